// Patterns: functions of the point (and for some of the surface) with values from 0 to 1, by which pigments, normals
// and textures choose from their maps. A record says which and with what operands; renderer/patterns
// evaluates it.
#pragma once

#include "base/source_span.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/operands.h"
#include "renderer/scene/warp.h"

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <variant>
#include <vector>

namespace isl::scene {

/// POV-Ray's patterns, by its names; a descriptor of each is in renderer/patterns/kinds/. `plain` is no pattern: the
/// same everywhere.
enum class PatternKind : std::uint8_t {
  plain,
#define ISL_PATTERN(name, frequency) name,
#include "renderer/scene/patterns.def"
#undef ISL_PATTERN
};

namespace detail {

inline constexpr double kDefaultFrequencies[] = {
    1,
#define ISL_PATTERN(name, frequency) frequency,
#include "renderer/scene/patterns.def"
#undef ISL_PATTERN
};

}  // namespace detail

inline constexpr std::size_t kPatternKindCount = std::size(detail::kDefaultFrequencies);

/// The frequency of a pattern that does not say.
[[nodiscard]] constexpr double default_frequency(PatternKind kind) {
  return detail::kDefaultFrequencies[static_cast<std::size_t>(kind)];
}

/// The wave form by which the value v of a pattern goes up and down: as fmod(v · frequency + phase, 1) through the
/// wave.
enum class Wave : std::uint8_t { ramp, triangle, sine, scallop, cubic, poly };

// Operands that refer to another record of the database.
struct FunctionOperands {
  FunctionId function = kNoFunction;
};
/// The first item of the map outside the object, the second inside. An index into Database::pattern_objects.
struct ObjectOperands {
  std::uint32_t object = kNone;
};
struct PigmentOperands {
  PigmentId pigment{};
};

/// By kind; std::monostate where a pattern has none. Operands: those that the kind's descriptor declares.
using PatternOperands =
    std::variant<std::monostate, Operands, FunctionOperands, ImageId, ObjectOperands, PigmentOperands>;

struct Pattern {
  PatternKind kind = PatternKind::plain;
  Wave wave = Wave::ramp;
  bool uv_mapping = false;           ///< the point is (u, v, 0) of the surface; objects' transforms do not move it
  std::uint8_t noise_generator = 0;  ///< 0: the scene's
  double exponent = 1;               ///< of Wave::poly
  double frequency = 1;
  double phase = 0;
  Turbulence turbulence;    ///< applied last of all, in the pattern's own space, wherever it was written
  std::vector<Warp> warps;  ///< in the order of writing: the point meets the last one first
  PatternOperands operands;
  OriginId said_at{};
};

}  // namespace isl::scene
