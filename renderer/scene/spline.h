// Splines: the content of `spline { … }`. Plain data; renderer/values/spline.h evaluates it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace isl::scene {

/// How a spline runs between its points (POV-Ray's four kinds).
enum class SplineKind : std::uint8_t { linear, quadratic, cubic, natural };

struct SplinePoint {
  double parameter = 0;
  std::array<double, 5> value{};    ///< unused terms are zero
  std::array<double, 5> bending{};  ///< second derivative of a natural spline at the point
};

/// Points in ascending order of their parameters, no two of which are equal; at least one.
struct Spline {
  SplineKind kind = SplineKind::linear;
  int term_count = 2;  ///< 2 to 5: the longest of its values; a value of one number counts as two equal terms
  std::vector<SplinePoint> points;
};

}  // namespace isl::scene
