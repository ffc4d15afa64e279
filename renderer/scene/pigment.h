// Colours of surfaces.
#pragma once

#include "renderer/scene/colour.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/pattern.h"

#include <optional>
#include <vector>

namespace isl::scene {

/// The pigment in a texture, a map or a list: a uniform colour is stored inline, any other pigment is an id. Comparable
/// byte by byte except for its place.
struct Pigment {
  Colour colour{};                   ///< POV-Ray's default pigment is black
  PigmentId pattern = kPlainColour;  ///< for any other value the colour is unused
  OriginId said_at{};                ///< place of a uniform colour

  [[nodiscard]] bool is_plain() const { return pattern == kPlainColour; }
};

static_assert(sizeof(Pigment) == sizeof(Colour) + 2 * sizeof(std::uint32_t), "no padding");

/// A pigment with a pattern, or with more data than a colour.
struct PatternedPigment {
  Pattern pattern{};
  Colour colour{};  ///< of PatternKind::plain
  /// The map from which the pattern chooses; a colour_map has plain pigments. kNoPigmentMap: black to white.
  PigmentMapId map = kNoPigmentMap;
  std::optional<Colour> quick_colour{};  ///< for previews
};

struct PigmentEntry {
  double value = 0;  ///< of the pattern; weight in an average; position in a list (checker, brick …)
  Pigment pigment{};
};

/// Entries in ascending order of value, except for averages. Colours between two entries are interpolated linearly.
using PigmentMap = std::vector<PigmentEntry>;

}  // namespace isl::scene
