// The renderer's own fields (renderer/fields) behind the suite's interface: a blob of one component and threshold 0, so
// that F = f. Compiled for one SIMD target; renderer_tests show that all vector widths give the same bits.
#include "renderer/compiled/blob_point-inl.h"
#include "tests/conformance/field_under_test.h"
#include "tests/support/ray_fields.h"

#include <array>
#include <memory>

namespace isl::conformance {
namespace {

namespace lanes = render::HWY_NAMESPACE;

/// A compiled blob of one component, in a grid of one cell.
render::CompiledBlob single(const FieldCase& field) {
  const scene::Database database = blob_of(field, 0);
  render::CompiledBlob blob;
  blob.components = render::compile_components(database, database.blobs[0]);
  blob.grid.items.assign(1 + render::Grid::kListTail, 0);
  blob.grid.cells = {render::Cell::make(render::CellKind::leaf, 0, 1)};
  return blob;
}

}  // namespace

FieldUnderTest product_field_under_test(const FieldCase& tested_case) {
  const auto blob = std::make_shared<const render::CompiledBlob>(single(tested_case));
  const auto on = [blob](const Vec3& origin, const Vec3& direction, double t0, double t1) {
    return test::RayFields(blob->components, origin, direction, t0, t1);
  };
  using Bound = render::FieldRange (test::RayFields::*)(double, double) const;
  const auto bounded = [on](Bound bound) {
    return [on, bound](const Vec3& origin, const Vec3& direction, double t0, double t1) -> ValueRange {
      const render::FieldRange range = (on(origin, direction, t0, t1).*bound)(t0, t1);
      return {range.low, range.high};
    };
  };
  const auto along = [on](const Vec3& origin, const Vec3& direction, double t) -> ValueAndDerivative {
    const test::RayValue f = on(origin, direction, t, t).at(t);
    return {f.value, f.slope};
  };
  FieldUnderTest field;
  field.along_ray = along;
  field.value = [along](const Vec3& p) { return along(p, Vec3(0.36, 0.48, 0.8), 0).value; };
  field.gradient = [blob](const Vec3& p) {
    const scene::CoordinateTextures none;
    render::BlobPoint point;
    lanes::blob_point(*blob, 0, p, {&none, scene::kNoTexture}, point);
    return point.fields.gradient;
  };
  field.range_over_box = [blob](const Vec3& low, const Vec3& high) -> ValueRange {
    const render::FieldRange range =
        render::field_range(blob->components, blob->components.groups.front(), 0, render::Box(low, high));
    return {range.low, range.high};
  };
  field.range_along_ray = bounded(&test::RayFields::range);
  field.slope_range_along_ray = bounded(&test::RayFields::slope_range);
  field.bend_range_along_ray = bounded(&test::RayFields::bend_range);
  field.remainder = [on](const Vec3& origin, const Vec3& direction, double t0, double t1) -> RemainderBounds {
    const test::RayRemainder bound = on(origin, direction, t0, t1).remainder(t0, t1);
    return {bound.value, bound.slope};
  };
  return field;
}

}  // namespace isl::conformance
