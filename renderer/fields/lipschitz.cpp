#include "renderer/fields/lipschitz.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

double frobenius_norm(const scene::Matrix& m) {
  double sum = 0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) sum += m[row][column] * m[row][column];
  }
  return std::sqrt(sum);
}

}  // namespace

FieldRange lipschitz_range(const ComponentTable& table, const FieldGroup& group, std::uint32_t component,
                           const Box& box) {
  double half = 0.5 * box.size().length();
  if (group.kernel.is_convolved || !std::isfinite(half)) return field_range(table, group, component, box);
  Vec3 middle = box.center();
  if (group.is_mapped) {
    const scene::Transform& map = table.blob_from_component(group, component);
    middle = map.inverse_point(middle);
    half *= frobenius_norm(map.inverse);
  }
  const double root_scale = std::sqrt(ComponentTable::v_scale(group));
  double root_v = 0, change = 0;  // √v at the centre, and its greatest change within the box
  table.with_skeleton(group, component, [&](const auto& shape) {
    root_v = root_scale * std::sqrt(shape.nearest(middle).q());
    change = root_scale * half / thinnest(shape);
  });
  const double low = std::max(root_v - change, 0.0), support = group.kernel.support;
  if (!(low * low < support)) return {0, 0};
  const double high = std::min(root_v + change, std::sqrt(support));
  const double amplitude = table.amplitude[component];
  const double value = amplitude * kernel_profile(group.kernel, root_v * root_v);
  const double room = std::abs(amplitude * 2 * high * kernel_slope(group.kernel, low * low)) * change;
  return {value - room, value + room};
}

}  // namespace isl::render
