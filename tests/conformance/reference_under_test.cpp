// The reference behind the interface of the conformance suite, which proves that the properties can be satisfied.
#include "renderer/reference/reference_ray.h"
#include "tests/conformance/field_under_test.h"

#include <cmath>
#include <memory>

namespace isl::conformance {
namespace {

using reference::exactly;
using reference::FieldOnRay;
using reference::FieldSample;
using reference::Interval;
using reference::interval_of;
using reference::Jet;
using reference::ReferenceField;

double rounded(long double x) { return static_cast<double>(x); }

/// The bounds follow from the range [m, M] of f′ alone. The cubic's slope is a quadratic with Bernstein coefficients
/// f′(t0), 3s − f′(t0) − f′(t1) and f′(t1), where s, the mean slope, also lies in [m, M]. So the slopes differ by at
/// most the width of the interval that holds all of them, and the values, which agree at both ends, by that times half
/// the length.
RemainderBounds remainder_from_slopes(const FieldOnRay& ray, long double t0, long double t1) {
  const Jet first = ray.at(t0), last = ray.at(t1);
  const Interval slopes = ray.over(t0, t1).slope;
  const Interval mean = common(slopes, (last.value - first.value) / (Interval(t1) - Interval(t0)));
  const Interval middle = Interval(3) * mean - first.slope - last.slope;
  const long double width = hull(slopes, middle).width();
  return {rounded(width * (t1 - t0) / 2), rounded(width)};
}

}  // namespace

FieldUnderTest reference_field_under_test(const FieldCase& tested_case) {
  const scene::Database database = blob_of(tested_case, 1);
  const auto field = std::make_shared<const ReferenceField>(database, database.blobs[0]);
  const auto sample = [field](const reference::Vector<long double>& p) {
    return field->components().front().sample(p);
  };

  FieldUnderTest tested;
  tested.value = [sample](const Vec3& p) { return rounded(sample(exactly(p)).value); };
  tested.gradient = [sample](const Vec3& p) {
    const reference::Vector<long double> g = sample(exactly(p)).gradient;
    return Vec3(rounded(g.x), rounded(g.y), rounded(g.z));
  };
  tested.along_ray = [sample](const Vec3& origin, const Vec3& direction, double t) {
    const FieldSample here = sample(exactly(origin) + exactly(direction) * static_cast<long double>(t));
    return ValueAndDerivative{rounded(here.value), rounded(dot(here.gradient, exactly(direction)))};
  };
  tested.range_over_box = [field](const Vec3& low, const Vec3& high) {
    const Interval range = field->components().front().range({{low.x, high.x}, {low.y, high.y}, {low.z, high.z}});
    return ValueRange{rounded(range.lo()), rounded(range.hi())};
  };
  tested.range_along_ray = [field](const Vec3& origin, const Vec3& direction, double t0, double t1) {
    const FieldOnRay ray(*field, {interval_of(origin), interval_of(direction)});
    const Interval range = ray.over(t0, t1).value + Interval(field->threshold());
    return ValueRange{rounded(range.lo()), rounded(range.hi())};
  };
  tested.slope_range_along_ray = [field](const Vec3& origin, const Vec3& direction, double t0, double t1) {
    const FieldOnRay ray(*field, {interval_of(origin), interval_of(direction)});
    const Interval range = ray.over(t0, t1).slope;
    return ValueRange{rounded(range.lo()), rounded(range.hi())};
  };
  tested.bend_range_along_ray = [field](const Vec3& origin, const Vec3& direction, double t0, double t1) {
    const FieldOnRay ray(*field, {interval_of(origin), interval_of(direction)});
    const Interval range = ray.over(t0, t1).bend;
    return ValueRange{rounded(range.lo()), rounded(range.hi())};
  };
  tested.remainder = [field](const Vec3& origin, const Vec3& direction, double t0, double t1) {
    return remainder_from_slopes(FieldOnRay(*field, {interval_of(origin), interval_of(direction)}), t0, t1);
  };
  return tested;
}

}  // namespace isl::conformance
