// The interface of a field implementation in the conformance suite: one component's f, without blobs or thresholds. For
// a new implementation, add a maker to implementations.cpp; field_cases and properties then apply to it without change.
#pragma once

#include "tests/conformance/field_cases.h"

#include <functional>
#include <string>
#include <vector>

namespace isl::conformance {

using scene::Vec3;

struct ValueAndDerivative {
  double value;
  double derivative;  ///< d/dt
};

struct ValueRange {
  double low, high;
};

/// Bounds on the error of the cubic that agrees with f and f′ at both ends of a stretch of ray.
struct RemainderBounds {
  double value;       ///< bound of |f − cubic|
  double derivative;  ///< bound of |f′ − cubic′|
};

/// All functions are in the blob's space, with `strength` and transform applied. All must be given.
struct FieldUnderTest {
  std::function<double(const Vec3& p)> value;
  std::function<Vec3(const Vec3& p)> gradient;
  /// f and df/dt at origin + t·direction; the direction may have any length but zero.
  std::function<ValueAndDerivative(const Vec3& origin, const Vec3& direction, double t)> along_ray;
  /// Encloses f over the box.
  std::function<ValueRange(const Vec3& low, const Vec3& high)> range_over_box;
  /// Encloses f over a stretch of a ray.
  std::function<ValueRange(const Vec3& origin, const Vec3& direction, double t0, double t1)> range_along_ray;
  /// Encloses df/dt over a stretch of a ray.
  std::function<ValueRange(const Vec3& origin, const Vec3& direction, double t0, double t1)> slope_range_along_ray;
  /// Encloses (f′(t) − f′(s))/(t − s) for all s < t on a stretch of a ray.
  std::function<ValueRange(const Vec3& origin, const Vec3& direction, double t0, double t1)> bend_range_along_ray;
  std::function<RemainderBounds(const Vec3& origin, const Vec3& direction, double t0, double t1)> remainder;
};

/// A named way of making fields.
struct Implementation {
  std::string name;
  std::function<FieldUnderTest(const FieldCase&)> make;
};

/// All implementations; the reference is the first.
[[nodiscard]] const std::vector<Implementation>& implementations();

/// The reference (renderer/reference) behind this interface.
[[nodiscard]] FieldUnderTest reference_field_under_test(const FieldCase& tested_case);

/// renderer/fields behind this interface.
[[nodiscard]] FieldUnderTest product_field_under_test(const FieldCase& tested_case);

}  // namespace isl::conformance
