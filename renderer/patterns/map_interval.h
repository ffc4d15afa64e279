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

/// find_in() for a value between the first and the last entry.
template <class Entry>
[[nodiscard]] MapInterval<Entry> find_within(const std::vector<Entry>& map, double value) noexcept {
  const auto second =
      std::find_if(map.begin() + 1, map.end(), [value](const Entry& entry) { return value <= entry.value; });
  const auto first = second - 1;
  const double low = values::to_single(first->value), high = values::to_single(second->value);
  return {&*first, &*second, (value - low) / values::to_single(high - low)};
}

/// The map is not empty. Its values are compared in single precision, as in POV-Ray; NaN gives the last entry.
template <class Entry>
[[nodiscard, gnu::always_inline]] inline MapInterval<Entry> find_in(const std::vector<Entry>& map,
                                                                    double value) noexcept {
  // Which end of a list of two it is is as good as random, so it is an index and no branch.
  const bool is_first = value <= map.front().value, is_last = !(value < map.back().value);
  if (static_cast<int>(is_first) + static_cast<int>(is_last) == 0) return find_within(map, value);
  const Entry* const end = map.data() + (is_last ? map.size() - 1 : 0);
  return {end, end, 0};
}

}  // namespace isl::render
