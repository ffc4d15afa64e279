// Lookup of a value in a map of colours, pigments or textures.
#pragma once

#include "renderer/values/single_precision.h"

#include <algorithm>
#include <vector>

namespace isl::render {

/// The two entries around a value, and its relative position between them.
template <class Entry>
struct MapInterval {
  const Entry* first;
  const Entry* second;  ///< may be equal to `first`
  double fraction;
};

/// The map is not empty. Its values are compared in single precision, as in POV-Ray; NaN gives the last entry.
template <class Entry>
[[nodiscard]] MapInterval<Entry> find_in(const std::vector<Entry>& map, double value) noexcept {
  if (!(value < map.back().value)) return {&map.back(), &map.back(), 0};
  const auto second =
      std::find_if(map.begin(), map.end(), [value](const Entry& entry) { return value <= entry.value; });
  if (second == map.begin()) return {&map.front(), &map.front(), 0};
  const auto first = second - 1;
  const double low = values::to_single(first->value), high = values::to_single(second->value);
  return {&*first, &*second, (value - low) / values::to_single(high - low)};
}

}  // namespace isl::render
