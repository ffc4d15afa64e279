#include "tests/support/ray_fields.h"

#include "renderer/fields/ray/ray_lanes-inl.h"
#include "renderer/grid/grid.h"

#include <cstdint>
#include <utility>

// Functions that call the inlined loops must be compiled for the same vectors.
HWY_BEFORE_NAMESPACE();
namespace isl::test {

struct RayFields::Lanes {
  render::LaneMemory memory;
  render::HWY_NAMESPACE::RayLanes fields{memory};
};

RayFields::RayFields(const render::ComponentTable& table, const scene::Vec3& origin, const scene::Vec3& direction,
                     double t0, double t1) {
  constexpr std::uint32_t kFirst[1 + render::Grid::kListTail] = {};
  auto lanes = std::make_unique<Lanes>();
  lanes->fields.set_up(table, kFirst, 1, origin, direction, t0, t1);
  lanes_ = std::move(lanes);
}

RayFields::~RayFields() = default;

RayValue RayFields::at(double t) const {
  const render::HWY_NAMESPACE::FieldAt f = lanes_->fields.at(t);
  return {f.value, f.slope, f.steepness, lanes_->fields.noise(t, f)};
}

render::FieldRange RayFields::range(double a, double b) const { return lanes_->fields.range(a, b); }
render::FieldRange RayFields::slope_range(double a, double b) const { return lanes_->fields.slope_range(a, b); }
render::FieldRange RayFields::bend_range(double a, double b) const { return lanes_->fields.bend_range(a, b); }

RayRemainder RayFields::remainder(double a, double b) const {
  const render::HWY_NAMESPACE::Remainder r = lanes_->fields.remainder(a, b);
  return {r.value, r.slope};
}

}  // namespace isl::test
HWY_AFTER_NAMESPACE();
