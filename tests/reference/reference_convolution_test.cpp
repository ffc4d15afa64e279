// The reference's convolutions: compared with closed forms where these are short, and their enclosures with samples.
#include "renderer/reference/reference_convolution.h"
#include "renderer/reference/reference_kernel.h"
#include "renderer/reference/reference_skeleton.h"
#include "tests/reference/near.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace isl::reference {
namespace {

/// The field at a place, and over a stretch of a line.
Jet at(const ReferenceConvolution& field, const Line& line, long double t) { return field.at(line.at(t)); }
Jet over(const ReferenceConvolution& field, const Line& line, long double t0, long double t1) {
  return field.over(line.at({t0, t1})).jet;
}
Line towards(const Vector<Interval>& place) { return {place, {1, 0, 0}}; }

const scene::Kernel kWindows[] = {convolved(quartic(0.5)), convolved(quartic(4)), convolved(quartic(100)),
                                  convolved(cauchy(0.5)),  convolved(cauchy(4)),  convolved(cauchy(60))};

TEST(ReferenceWindow, OfAnInfiniteLineHasTheValueOneAndTheSlopeOfItsHardnessAtTheRadius) {
  for (const scene::Kernel& kernel : kWindows) {
    const ReferenceKernel line(kernel);
    EXPECT_CLOSE(line.value(1), 1, 1e-16L);
    EXPECT_CLOSE(line.slope(1) / kernel.hardness, -1, 1e-16L);
    if (kernel.shape == scene::KernelShape::cauchy) {
      EXPECT_CLOSE(std::log(line.value(0)) / kernel.hardness, 1, 1e-16L);
    }
  }
}

TEST(ReferenceWindow, OfAQuarticMakesThePowerFiveHalvesOfALine) {
  const ReferenceKernel line(convolved(quartic(4)));
  for (const long double q : {0.0L, 0.2L, 1.0L, 1.5L, 1.62L}) {
    const long double depth = 1 - q / 1.625L;  // Q = 1 + 5/(2h)
    EXPECT_CLOSE(line.value(q), std::pow(depth / (1 - 1 / 1.625L), 2.5L), 1e-15L);
  }
  EXPECT_EQ(line.value(1.626L), 0);
}

/// The quartic's antiderivative along a segment, A = 1 − ρ²: v(A² − (v²)(2A/3 − v²/5)).
TEST(ReferenceConvolution, OfASegmentIsTheQuarticsAntiderivative) {
  const scene::Kernel kernel = convolved(quartic(2));
  const ReferenceWindow window(kernel);
  const long double support = std::sqrt(window.border()) * 0.5L;
  const ReferenceConvolution field(segment({0, 0, 0}, {1, 0, 0}, 0.5), kernel);
  RandomSource random(1);
  for (int i = 0; i < 200; ++i) {
    const long double x = random.between(-0.6, 1.6), y = random.between(0, 0.7);
    const long double a = 1 - y * y / (support * support);
    if (a <= 0) continue;
    const auto part = [&](long double v) {
      v = std::clamp(v / support, -std::sqrt(a), std::sqrt(a));
      return v * (a * a - v * v * (2 * a / 3 - v * v / 5));
    };
    const Interval value = at(field, towards({x, y, 0}), 0).value;
    EXPECT_CLOSE(value.middle(), window.amplitude() * (part(1 - x) - part(-x)), 1e-16L);
    EXPECT_LE(value.width(), 1e-15L);
  }
}

/// McCormack and Sherstyuk's ring, seen from its centre: all its points have the same distance.
TEST(ReferenceConvolution, OfACircleAtItsCentreIsItsLengthTimesTheWindow) {
  for (const scene::Kernel& kernel : kWindows) {
    const ReferenceWindow window(kernel);
    const long double support = std::sqrt(window.border()) * 0.5L, radius = 0.4L;
    const ReferenceConvolution field(circle({0, 0, 0}, {0, 0, 1}, 0.4, 0.5), kernel);
    const long double y = static_cast<long double>(0.4) * 0.4 / (support * support);
    const long double length = 2 * 3.14159265358979323846L * radius / support;
    const long double expected = y < 1 ? window.amplitude() * length * window.at(y, 1 - y).value : 0;
    EXPECT_CLOSE(at(field, towards({0, 0, 0}), 0).value.middle(), expected, 1e-15L * (1 + expected));
  }
}

TEST(ReferenceConvolution, BoundsHoldEverySampleAndNarrowWithTheStretch) {
  RandomSource random(2);
  const scene::Component curves[] = {segment({-0.5, 0, 0.1}, {0.6, 0.3, -0.2}, 0.3),
                                     circle({0, 0.1, 0}, {0, 0.6, 0.8}, 0.5, 0.2),
                                     circle({0, 0.1, 0}, {0, 0.6, 0.8}, 0.1, 0.4)};
  int something = 0;
  for (const scene::Kernel& kernel : kWindows) {
    for (const scene::Component& curve : curves) {
      const ReferenceConvolution field(curve, kernel);
      for (int i = 0; i < 40; ++i) {
        const LineOfSight sight = random_line(random, 2, 0.7);
        const Line line{interval_of(sight.origin), interval_of(sight.direction)};
        const long double t0 = random.between(0.5, 3), t1 = t0 + std::pow(10, random.between(-4, 0));
        const Jet range = over(field, line, t0, t1);
        const Interval whole(t0, t1);
        const Jet sharp = sharpened(range, at(field, line, whole.middle()), whole.radius());
        const long double least = field.over(line.at(whole)).least;
        Interval slope_before(0);
        for (int k = 0; k <= 20; ++k) {
          const Jet here = at(field, line, t0 + (t1 - t0) * k / 20);
          something += here.value.hi() > 0 ? 1 : 0;
          ASSERT_LE(least, here.value.hi());
          for (const Jet& all : {range, sharp}) {
            ASSERT_LE(all.value.lo(), here.value.hi());
            ASSERT_GE(all.value.hi(), here.value.lo());
            ASSERT_LE(all.slope.lo(), here.slope.hi());
            ASSERT_GE(all.slope.hi(), here.slope.lo());
          }
          const Interval bend = (here.slope - slope_before) / Interval((t1 - t0) / 20);
          ASSERT_TRUE(k == 0 || (range.bend.lo() <= bend.hi() && range.bend.hi() >= bend.lo()));
          slope_before = here.slope;
        }
        const long double h = 1e-9L;
        const Jet first = at(field, line, t0), next = at(field, line, t0 + h);
        EXPECT_LE(sharpened(over(field, line, t0, t0 + h), first, h).value.width(), 1e-3L * (1 + first.value.hi()));
        const long double difference = (next.value.middle() - first.value.middle()) / h;
        EXPECT_CLOSE(difference, first.slope.middle(), 1e-4L * (1 + std::abs(difference)));
      }
    }
  }
  EXPECT_GT(something, 4000);
}

TEST(ReferenceConvolution, GradientIsThatOfTheValue) {
  RandomSource random(3);
  const scene::Component curves[] = {segment({-0.5, 0, 0.1}, {0.6, 0.3, -0.2}, 0.3),
                                     circle({0, 0.1, 0}, {0, 0.6, 0.8}, 0.5, 0.2),
                                     circle({0, 0.1, 0}, {0, 0.6, 0.8}, 0.1, 0.4)};
  for (const scene::Kernel& kernel : {convolved(quartic(4)), convolved(cauchy(4))}) {
    for (const scene::Component& curve : curves) {
      const ReferenceConvolution field(curve, kernel);
      for (int i = 0; i < 50; ++i) {
        const scene::Vec3 p = random.in_ball(0.8), n = random.direction();
        const Line line{interval_of(p), interval_of(n)};
        constexpr long double kStep = 1e-6L;
        const long double difference =
            (at(field, line, kStep).value.middle() - at(field, line, -kStep).value.middle()) / (2 * kStep);
        EXPECT_CLOSE(at(field, line, 0).slope.middle(), difference, 1e-7L * (1 + std::abs(difference)));
      }
    }
  }
}

}  // namespace
}  // namespace isl::reference
