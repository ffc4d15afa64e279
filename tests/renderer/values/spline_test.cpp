#include "renderer/values/spline.h"

#include <gtest/gtest.h>

#include <limits>

namespace isl::values {
namespace {

using scene::Spline;
using scene::SplineKind;

constexpr SplineKind kKinds[] = {SplineKind::linear, SplineKind::quadratic, SplineKind::cubic, SplineKind::natural};

Spline parabola() {
  Spline spline;
  for (const double t : {2.0, 0.0, 3.0, 1.0, 4.5}) insert(spline, t, {t * t, -t});
  finish(spline);
  return spline;
}

TEST(Splines, PassThroughTheirPoints) {
  const Spline spline = parabola();
  for (const SplineKind kind : kKinds) {
    for (const double t : {1.0, 2.0, 3.0}) {
      EXPECT_DOUBLE_EQ(evaluate(spline, kind, t)[0], t * t);
      EXPECT_DOUBLE_EQ(evaluate(spline, kind, t)[1], -t);
    }
  }
}

TEST(Splines, QuadraticIsExactOnAParabola) {
  const Spline spline = parabola();
  for (double t = 0; t < 4.5; t += 0.125) EXPECT_NEAR(evaluate(spline, SplineKind::quadratic, t)[0], t * t, 1e-12);
}

TEST(Splines, AllKindsButCubicAreExactOnALineAndHoldTheirEnds) {
  const Spline spline = parabola();
  for (const SplineKind kind : {SplineKind::linear, SplineKind::quadratic, SplineKind::natural}) {
    for (double t = 0; t < 4.5; t += 0.125) EXPECT_NEAR(evaluate(spline, kind, t)[1], -t, 1e-12);
    EXPECT_EQ(evaluate(spline, kind, -7)[1], 0);
    EXPECT_EQ(evaluate(spline, kind, 99)[1], -4.5);
  }
}

TEST(Splines, CubicRunsBetweenTheInnerPoints) {
  const Spline spline = parabola();
  EXPECT_EQ(evaluate(spline, SplineKind::cubic, 0.5)[0], 1);
  EXPECT_EQ(evaluate(spline, SplineKind::cubic, 4)[0], 9);
}

TEST(Splines, NotANumberGivesANumber) {
  const Spline spline = parabola();
  for (const SplineKind kind : kKinds) {
    const double value = evaluate(spline, kind, std::numeric_limits<double>::quiet_NaN())[0];
    EXPECT_EQ(value, value);
  }
}

TEST(Splines, FewPointsAreEnough) {
  Spline spline;
  insert(spline, 1, {3, 4});
  finish(spline);
  for (const SplineKind kind : kKinds) EXPECT_EQ(evaluate(spline, kind, 7)[0], 3);
  insert(spline, 2, {5, 4});
  finish(spline);
  for (const SplineKind kind : kKinds) EXPECT_EQ(evaluate(spline, kind, 1.5)[0], 4);
}

TEST(Splines, APointAgainTakesItsPlaceExceptAtTheEnd) {
  Spline spline;
  for (const double t : {0.0, 1.0, 2.0}) insert(spline, t, {t});
  insert(spline, 1, {10});
  insert(spline, 2, {20});
  finish(spline);
  EXPECT_EQ(spline.points.size(), 3u);
  EXPECT_EQ(evaluate(spline, SplineKind::linear, 1)[0], 10);
  EXPECT_EQ(evaluate(spline, SplineKind::linear, 2)[0], 2);
}

}  // namespace
}  // namespace isl::values
