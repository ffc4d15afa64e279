// Patterns: functions of the point (some also of the surface) with values from 0 to 1, by which pigments, normals and
// textures choose from their maps. A record holds the kind and its operands; renderer/patterns evaluates it.
#pragma once

#include "base/source_span.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/operands.h"
#include "renderer/scene/warp.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <variant>
#include <vector>

namespace isl::scene {

/// POV-Ray's patterns, with its names. Their descriptors are in renderer/patterns/kinds/. `plain` stands for a uniform
/// value.
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

/// The frequency of a pattern for which the scene sets none.
[[nodiscard]] constexpr double default_frequency(PatternKind kind) {
  return detail::kDefaultFrequencies[static_cast<std::size_t>(kind)];
}

/// The waveform that shapes a pattern's value v: the result is wave(fmod(v · frequency + phase, 1)).
/// `none` leaves v as it is.
enum class Wave : std::uint8_t { ramp, triangle, sine, scallop, cubic, poly, none };

// Operands that refer to another record of the database.
struct FunctionOperands {
  FunctionId function = kNoFunction;
};
/// The `object` pattern has item 0 of its list outside the object and item 1 inside.
struct ObjectOperands {
  std::uint32_t object = kNone;
  bool less_threshold = false;  ///< of `potential`: the field minus its threshold
};
/// Of `user_defined`: the terms of a colour, in the order of Colour; kNoFunction for 0.
struct ColourOperands {
  std::array<FunctionId, 5> terms{kNoFunction, kNoFunction, kNoFunction, kNoFunction, kNoFunction};
};
struct PigmentOperands {
  PigmentId pigment{};
};

/// std::monostate if the kind has no operands. Operands: those that the kind's descriptor declares.
using PatternOperands =
    std::variant<std::monostate, Operands, FunctionOperands, ImageId, ObjectOperands, PigmentOperands, ColourOperands>;

struct Pattern {
  PatternKind kind = PatternKind::plain;
  Wave wave = Wave::ramp;
  bool uv_mapping = false;           ///< the point is (u, v, 0) of the surface; transforms of objects do not move it
  std::uint8_t noise_generator = 0;  ///< 0: the scene's
  double exponent = 1;               ///< of Wave::poly
  double frequency = 1;
  double phase = 0;
  Turbulence turbulence;    ///< applied after all warps, in the pattern's own space, wherever the scene has it
  std::vector<Warp> warps;  ///< in the order of the scene; the last one is applied to the point first
  PatternOperands operands;
  OriginId said_at{};
};

}  // namespace isl::scene
