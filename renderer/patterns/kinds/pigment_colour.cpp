#include "renderer/patterns/kinds/pigment_colour.h"

namespace isl::render {

using scene::Colour;
using values::to_single;

Colour blend(const Colour& a, const Colour& b, double fraction) noexcept {
  const auto mix = [fraction](double from, double to) -> double {
    const auto first = static_cast<float>(from), second = static_cast<float>(to);
    return first + static_cast<float>(fraction * (second - first));
  };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue), mix(a.filter, b.filter),
          mix(a.transmit, b.transmit)};
}

void WeightedMean::add(const Colour& c, double weight) noexcept {
  const double w = to_single(weight);
  const auto add_to = [w](double& sum, double term) { sum = to_single(sum + to_single(term * w)); };
  add_to(sum_.red, c.red);
  add_to(sum_.green, c.green);
  add_to(sum_.blue, c.blue);
  add_to(sum_.filter, c.filter);
  add_to(sum_.transmit, c.transmit);
  total_ = to_single(total_ + w);
}

Colour WeightedMean::colour() const noexcept {
  const Colour& c = sum_;
  if (total_ == 0) return {};
  return in_single({c.red / total_, c.green / total_, c.blue / total_, c.filter / total_, c.transmit / total_});
}

double gray(const Colour& c) noexcept { return to_single(0.297 * c.red + 0.589 * c.green + 0.114 * c.blue); }

}  // namespace isl::render
