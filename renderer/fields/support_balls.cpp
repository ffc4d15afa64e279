#include "renderer/fields/support_balls.h"

#include "renderer/fields/component_table.h"

#include <algorithm>
#include <cmath>

namespace isl::render {

namespace {

/// Calls `use` with the centre and the radius of each ball, in the blob's space.
template <class Use>
void for_each_ball(const ComponentTable& table, const Use& use) {
  for (const FieldGroup& group : table.groups) {
    if (group.begin >= table.plain_points) return;
    for (std::uint32_t i = group.begin; i < group.end; ++i)
      use(Vec3(table.x[i], table.y[i], table.z[i]), std::sqrt(group.kernel.support / table.scale[i]));
  }
}

}  // namespace

SupportBalls support_balls(const ComponentTable& table) {
  SupportBalls supports;
  if (table.plain_points == 0) return supports;
  Box box;
  for_each_ball(table, [&](const Vec3& centre, double radius) {
    box.extendBy(centre - Vec3(radius));
    box.extendBy(centre + Vec3(radius));
  });
  const Vec3 size = box.size();
  supports.middle = box.center();
  supports.per_unit = 2 / std::max({size.x, size.y, size.z});
  supports.balls.reserve(table.plain_points);
  for_each_ball(table, [&](const Vec3& centre, double radius) {
    const Vec3 c = (centre - supports.middle) * supports.per_unit;
    supports.balls.push_back({static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z),
                              static_cast<float>(radius * supports.per_unit)});
  });
  return supports;
}

}  // namespace isl::render
