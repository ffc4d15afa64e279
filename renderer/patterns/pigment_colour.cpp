#include "renderer/patterns/pigment_colour.h"

#include "renderer/values/single_precision.h"

#include <algorithm>

namespace isl::render {

using scene::Colour;
using values::to_single;

MapInterval find_in(const scene::PigmentMap& map, double value) noexcept {
  if (value >= map.back().value) return {&map.back(), &map.back(), 0};
  const auto second =
      std::find_if(map.begin(), map.end(), [value](const scene::PigmentEntry& entry) { return value <= entry.value; });
  if (second == map.begin()) return {&map.front(), &map.front(), 0};
  const auto first = second - 1;
  const double low = to_single(first->value), high = to_single(second->value);
  return {&*first, &*second, (value - low) / (high - low)};
}

Colour in_single(const Colour& c) noexcept {
  return {to_single(c.red), to_single(c.green), to_single(c.blue), to_single(c.filter), to_single(c.transmit)};
}

Colour blend(const Colour& a, const Colour& b, double fraction) noexcept {
  const auto mix = [fraction](double from, double to) { return to_single(from + fraction * (to - from)); };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue), mix(a.filter, b.filter),
          mix(a.transmit, b.transmit)};
}

double gray(const Colour& c) noexcept { return to_single(0.297 * c.red + 0.589 * c.green + 0.114 * c.blue); }

}  // namespace isl::render
