// The descriptor of a kind of pattern: the words that begin it, its operands, what it chooses from, where it may stand,
// and its value at a point. The interpreter reads patterns by this, a dump prints them by it, and the renderer
// evaluates them and tells what it cannot draw. Each kind is one constant of this type in a file of this folder, under
// the name of its row in renderer/scene/patterns.def. Knows no text and no rays.
#pragma once

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

/// Answers questions of patterns that the database alone does not answer.
class PatternSurroundings {
 public:
  virtual ~PatternSurroundings() = default;
  /// `point` is in the space that the object is placed into.
  [[nodiscard]] virtual bool is_inside(const scene::Object& object, const scene::Vec3& point) const = 0;
};

/// The part of an evaluation that is the same for all patterns of a database.
struct PatternWorld {
  const scene::Database& database;
  const values::PatternSource& patterns;    ///< answers for patterns and pigments in patterns
  const PatternSurroundings* surroundings;  ///< may be null where no pattern is of an object
  int number_of_waves;                      ///< at most kMaxWaves count
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
  /// The pattern's own, or the scene's.
  [[nodiscard]] values::NoiseGenerator noise_generator() const noexcept {
    return pattern.noise_generator == 0 ? environment.noise_generator()
                                        : values::noise_generator_of(pattern.noise_generator);
  }
};

/// One colour of the map that pigments of a pattern have where the scene gives none.
struct PatternColour {
  double value;
  double red, green, blue;
};
inline constexpr PatternColour kBlackToWhite[] = {{0, 0, 0, 0}, {1, 1, 1, 1}};

struct PatternHosts {
  bool pigment = true, normal = true, texture = true, function = true;
};

/// The things that a pattern chooses from. `own` is for patterns that choose nothing and bring their own colours or
/// textures, as pictures do.
enum class PatternChoice : std::uint8_t { map, list, mean_of_map, own };

/// The content of the block, for patterns that are a block. `of_host` is an image whose block is read by the host of
/// the pattern, which has items there too. `function` is a value of the language and has no word.
enum class PatternBlock : std::uint8_t { none, optional, image, of_host, object, pigment, function };

/// The reason why a pattern is not evaluated: it asks for more of a surface than a point, or for a file that is not
/// opened.
enum class PatternLack : std::uint8_t { nothing, surface, file };

struct PatternInfo {
  std::span<const std::string_view> words = {};  ///< that begin it; none: its name
  PatternBlock block = PatternBlock::none;
  PatternHosts hosts = {};
  std::string_view instead = {};  ///< the word for other hosts
  bool makes_bumps = false;       ///< stands in normals more often than in pigments, for hints
  PatternChoice choice = PatternChoice::map;
  int list_length = 0;
  scene::Wave wave = scene::Wave::ramp;
  std::span<const PatternColour> colours = kBlackToWhite;  ///< a list's are all that it can have
  /// Tells whether a pattern with these operands has the `colours`; they go from black to white if it does not.
  bool (*has_colours)(const std::any& record) = nullptr;
  bool uses_turbulence_itself = false;  ///< so that it moves no points

  scene::Operands (*operands)() = nullptr;  ///< with their defaults
  /// Reads what follows one of `words`, which is given.
  void (*read)(scene::OperandReader& reader, std::any& record, std::string_view word) noexcept = nullptr;
  /// Looks for operands that do not go together, once all are read.
  void (*check)(scene::OperandReader& reader, const std::any& record) noexcept = nullptr;

  PatternLack lack = PatternLack::nothing;
  /// From 0 to about 1, or the item's number; null for what has no value: 0 is taken.
  double (*value)(const PatternPoint& at) noexcept = nullptr;

  [[nodiscard]] constexpr bool takes_map() const {
    return choice == PatternChoice::map || choice == PatternChoice::mean_of_map;
  }
};

/// The descriptor of a kind. `plain`, which is no pattern, has the defaults of all others.
[[nodiscard]] const PatternInfo& info_of(scene::PatternKind kind) noexcept;

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

/// The value modulo 1 above 1: POV-Ray does this to values without a bound before they meet frequency and phase.
[[nodiscard]] double below_1(double value) noexcept;

}  // namespace isl::render
