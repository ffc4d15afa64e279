// Colours of surfaces.
#pragma once

#include "renderer/scene/colour.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/pattern.h"

#include <optional>
#include <vector>

namespace isl::scene {

/// What a texture, a map and a list hold: a colour that is the same everywhere lies inline, all else is a number.
/// Comparable byte by byte but for its place.
struct Pigment {
  Colour colour{};                   ///< POV-Ray's default pigment is black
  PigmentId pattern = kPlainColour;  ///< else the colour says nothing
  OriginId said_at{};                ///< of a colour

  [[nodiscard]] bool is_plain() const { return pattern == kPlainColour; }
};

static_assert(sizeof(Pigment) == sizeof(Colour) + 2 * sizeof(std::uint32_t), "no padding");

/// A pigment that varies, or that has more to say than its colour.
struct PatternedPigment {
  Pattern pattern{};
  Colour colour{};  ///< of PatternKind::plain
  /// What the pattern chooses from; a colour_map is one of plain pigments. kNoPigmentMap: black to white.
  PigmentMapId map = kNoPigmentMap;
  std::optional<Colour> quick_colour{};  ///< for previews
};

struct PigmentEntry {
  double value = 0;  ///< of the pattern; weight in an average; position in a list (checker, brick …)
  Pigment pigment{};
};

/// In ascending order of value, averages excepted. Between two entries colours blend linearly.
using PigmentMap = std::vector<PigmentEntry>;

}  // namespace isl::scene
