// The descriptor of a kind of pattern: the words that begin it, its operands, the kind of map, the blocks that allow
// it, and its value at a point. The interpreter reads patterns by it, dumps print them by it, and the renderer
// evaluates them by it and reports those that it cannot draw. Each kind is one constant of this type in a file of this
// folder, with the name of its row in renderer/scene/patterns.def.
#pragma once

#include "renderer/patterns/kinds/sampled_image.h"
#include "renderer/scene/database.h"
#include "renderer/scene/operand_reader.h"
#include "renderer/scene/operands.h"
#include "renderer/scene/pattern.h"
#include "renderer/values/function_machine.h"
#include "renderer/values/pattern_source.h"

#include "base/check.h"

#include <span>
#include <string_view>

namespace isl::render {

using scene::Vec3;

/// Tests that patterns need and the database alone cannot answer.
class PatternSurroundings {
 public:
  virtual ~PatternSurroundings() = default;
  /// `point` is in the space that the object is placed into. When the steps are spent, the answer is meaningless.
  [[nodiscard]] virtual bool is_inside(const scene::Object& object, const scene::Vec3& point,
                                       StepCounter& steps) const = 0;
  /// The field of an object that is a blob, at a point of the same space.
  [[nodiscard]] virtual double field_of(const scene::Object& object, const scene::Vec3& point,
                                        StepCounter& steps) const = 0;
};

/// The part of an evaluation that is the same for all patterns of a database.
struct PatternWorld {
  const scene::Database& database;
  const values::PatternSource& patterns;    ///< evaluates patterns and pigments within patterns
  const PatternSurroundings* surroundings;  ///< may be null if there is no `object` pattern
  int number_of_waves;                      ///< limited to kMaxWaves
  const ImageTable* images;                 ///< may be null if there are no images
};

/// A pattern and the point at which it is evaluated, in the pattern's own space: after warps and turbulence.
struct PatternPoint {
  const scene::Pattern& pattern;
  const Vec3& point;
  values::Environment& environment;
  const PatternWorld& world;

  template <class Record>
  [[nodiscard]] const Record& operands() const noexcept {
    const auto* const operands = std::get_if<scene::Operands>(&pattern.operands);
    ISL_DCHECK(operands, "a pattern without its operands");
    return *std::any_cast<Record>(&operands->record);
  }
  /// The pattern's own noise generator, or the scene's if it sets none.
  [[nodiscard]] values::NoiseGenerator noise_generator() const noexcept {
    return pattern.noise_generator == 0 ? environment.noise_generator()
                                        : values::noise_generator_of(pattern.noise_generator);
  }
};

/// One colour of a pattern's default map, for pigments without a map.
struct PatternColour {
  double value;
  double red, green, blue;
};
inline constexpr PatternColour kBlackToWhite[] = {{0, 0, 0, 0}, {1, 1, 1, 1}};

struct PatternHosts {
  bool pigment = true, normal = true, texture = true, function = true;
};
inline constexpr PatternHosts kNormalsOnly{.pigment = false, .texture = false, .function = false};

/// The collection that a pattern chooses from. `own` is for patterns with colours or textures of their own, such as
/// images.
enum class PatternChoice : std::uint8_t { map, list, mean_of_map, own };

/// The content of a pattern's block, if it has one. `of_host` is an image whose block the host of the pattern reads,
/// because the block has the host's items too. `function` is a value of the language and has no word.
enum class PatternBlock : std::uint8_t { none, optional, image, of_host, object, blob, pigment, function, colours };

/// The reason why a pattern is not evaluated: it needs a file that is not opened.
enum class PatternLack : std::uint8_t { nothing, file };

struct PatternInfo {
  std::span<const std::string_view> words = {};  ///< words that begin the pattern; empty: its name
  PatternBlock block = PatternBlock::none;
  PatternHosts hosts = {};
  std::string_view instead = {};  ///< the word for other hosts
  bool makes_bumps = false;       ///< used in normals more often than in pigments; for hints
  PatternChoice choice = PatternChoice::map;
  int list_length = 0;
  scene::Wave wave = scene::Wave::ramp;
  std::span<const PatternColour> colours = kBlackToWhite;  ///< the default map; a list has no more items than these
  /// True if a pattern with these operands has `colours` as its default map; otherwise the map goes from black to
  /// white.
  bool (*has_colours)(const std::any& record) = nullptr;
  bool uses_turbulence_itself = false;  ///< its formula uses the turbulence, which then moves no points

  scene::Operands (*operands)() = nullptr;  ///< with their defaults
  /// Reads the operands that follow `word`, one of `words`.
  void (*read)(scene::OperandReader& reader, std::any& record, std::string_view word) noexcept = nullptr;
  /// Reports operands that contradict one another, after all are read.
  void (*check)(scene::OperandReader& reader, const std::any& record) noexcept = nullptr;

  PatternLack lack = PatternLack::nothing;
  /// The value, from 0 to about 1, or the item's index. Null for kinds without a value, which give 0.
  double (*value)(const PatternPoint& at) noexcept = nullptr;
  /// The values at points near at.point, for kinds that find them faster together. Null: one at a time.
  void (*values_near)(const PatternPoint& at, std::span<const Vec3> points,
                      std::span<double> values) noexcept = nullptr;
  /// The colour in single precision, for kinds with colours of their own.
  scene::Colour (*colour)(const PatternPoint& at) noexcept = nullptr;
  /// A unit normal as bumps of this size bend it, of any length. Null for kinds whose bumps are their values' heights.
  Vec3 (*bend)(const PatternPoint& at, const Vec3& normal, double size) noexcept = nullptr;

  [[nodiscard]] constexpr bool takes_map() const {
    return choice == PatternChoice::map || choice == PatternChoice::mean_of_map;
  }
};

/// The descriptors, in the order of PatternKind.
extern const PatternInfo* const kPatternInfos[];
/// The descriptor of a kind. `plain`, a uniform value, has the default of every member.
[[nodiscard]] inline const PatternInfo& info_of(scene::PatternKind kind) noexcept {
  return *kPatternInfos[static_cast<std::size_t>(kind)];
}

namespace pattern_kinds {
#define ISL_PATTERN(name, frequency) extern const PatternInfo name;
#include "renderer/scene/patterns.def"
#undef ISL_PATTERN
}  // namespace pattern_kinds

/// For PatternInfo::operands: a record with its defaults, and the list of its fields.
template <class Record, const auto& fields>
[[nodiscard]] scene::Operands operands_of() {
  return {Record{}, fields};
}

/// For PatternInfo::read: `function(OperandReader&, Record&, word) noexcept`.
template <class Record, auto function>
void read_operands(scene::OperandReader& reader, std::any& record, std::string_view word) noexcept {
  function(reader, *std::any_cast<Record>(&record), word);
}

/// For PatternInfo::check: `function(OperandReader&, const Record&) noexcept`.
template <class Record, auto function>
void check_operands(scene::OperandReader& reader, const std::any& record) noexcept {
  function(reader, *std::any_cast<Record>(&record));
}

/// Reduces values above 1 modulo 1, as POV-Ray does with unbounded values before it applies frequency and phase.
[[nodiscard]] double below_1(double value) noexcept;

}  // namespace isl::render
