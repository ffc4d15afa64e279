// The reference with 113 bits: it agrees with the one in long double, has the digits that it promises, and decides what
// that one leaves open, so that the solver does.
#include "tests/reference/wide_reference.h"

#include "renderer/reference/reference_tracer.h"
#include "tests/reference/rounding_rule.h"
#include "tests/reference/scale_cases.h"
#include "tests/reference/small_scenes.h"
#include "tests/reference/tracer_under_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace isl::reference {
namespace {

RayRoots long_double_roots(const scene::Database& database, const LineOfSight& line) {
  return roots_along(ReferenceField(database, database.blobs.front()),
                     {interval_of(line.origin), interval_of(line.direction)}, {});
}

TEST(WideReference, AgreesWithLongDoubleOnRandomBlobs) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RandomSource random(seed);
    RandomBlobOptions options;
    options.components = 1 + random.below(12);
    options.maxima = seed % 4 == 0;
    options.half_space = seed % 3 == 0;
    options.convolutions = seed % 5 == 0;
    options.hardest = seed % 2 == 0 ? 8 : 60;
    const scene::Database database = random_blob(random, options);
    for (const LineOfSight& line : random_lines(random, 4, 3, 0.7)) {
      const RayRoots known = long_double_roots(database, line);
      if (!known.touches.empty()) continue;
      const WideRoots wide = wide_roots(database, line);
      SCOPED_TRACE(seed);
      EXPECT_EQ(wide.starts_inside, known.starts_inside);
      EXPECT_EQ(wide.touches, 0U);
      ASSERT_EQ(wide.crossings.size(), known.crossings.size());
      for (std::size_t i = 0; i < known.crossings.size(); ++i) {
        const Crossing& crossing = known.crossings[i];
        EXPECT_LE(std::abs(wide.crossings[i].t - crossing.t),
                  crossing.slack + wide.crossings[i].slack + 0x1p-63L * crossing.t);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 100);
}

/// A constant or a function that went through a shorter type would leave errors of 10⁻¹⁹ or more.
TEST(WideReference, KernelsAreRightTo28Digits) {
  for (const double hardness : {0.4, 4.0, 60.0}) {
    for (const scene::Kernel& kernel : every_kernel(hardness)) {
      EXPECT_LT(wide_kernel_error(kernel), 1e-28) << static_cast<int>(kernel.shape) << ", hardness " << hardness;
    }
  }
  for (const scene::Kernel& kernel : {quartic(4), quartic(60), cauchy(4), cauchy(60)}) {
    EXPECT_LT(wide_kernel_error(over_sheets(kernel)), 1e-28) << kernel.hardness;
  }
}

/// Segments up to 10⁹ times as long as they are thick, along axes of space and askew, and rings from a thousandth to
/// 10⁶ times as wide. Along an axis the length costs no digit.
TEST(WideReference, HoldsWhatLongDoubleSaysOfConvolvedCurvesWithinItsBounds) {
  RandomSource random(5);
  int on_curve = 0;
  for (const double hardness : {0.5, 4.0, 60.0, 300.0}) {
    for (const scene::Kernel& kernel : {convolved(quartic(hardness)), convolved(cauchy(hardness))}) {
      for (int i = 0; i < 120; ++i) {
        const bool is_askew = i % 3 == 0, is_ring = i % 3 == 1;
        const scene::Vec3 aside = random.direction(), along = is_askew ? random.direction() : scene::Vec3(1, 0, 0);
        const double size = std::pow(10, is_ring ? random.between(-3, 6) : random.between(-1, 9));
        // A place on the curve is at the origin, one of a segment anywhere between its ends.
        const scene::Vec3 start = along * (-size * random.unit());
        const scene::Component curve = is_ring ? circle(along.cross(aside).normalized() * size, along, size, 1)
                                               : segment(start, start + along * size, 1);
        const scene::Database database = one_blob(kernel, {curve});
        const LineOfSight line = random_line(random, 4, 1.5);
        const ReferenceField field(database, database.blobs.front());
        const FieldOnRay on_line(field, {interval_of(line.origin), interval_of(line.direction)});
        for (int k = 0; k < 5; ++k) {
          const long double t = random.between(2.5, 5.5);
          const Jet here = on_line.at(t);
          const ValueAndSlope error = wide_error(database, line, t, {here.value.middle(), here.slope.middle()});
          SCOPED_TRACE(testing::Message() << "hardness " << hardness << ", curve " << i << ", size " << size);
          EXPECT_LE(error.value, here.value.radius());
          EXPECT_LE(error.slope, here.slope.radius());
          if (here.value.middle() <= -1) continue;
          ++on_curve;
          if (is_askew || is_ring) continue;
          EXPECT_LE(here.value.radius(), 1e-14L * hardness * (1 + here.value.magnitude()));
        }
      }
    }
  }
  EXPECT_GT(on_curve, 1000);
}

/// Lines that are integrated numerically; those near the border are a difference of nearly equal terms.
TEST(WideReference, ConvolvedLinesAreRightTo27Digits) {
  for (const double hardness : {0.4, 4.0, 60.0}) {
    for (const double y : {0.01, 0.3, 0.9}) {
      EXPECT_LT(wide_line_error(convolved(quartic(hardness)), y), 1e-31) << hardness << ", " << y;
    }
  }
  for (const double hardness : {0.4, 4.0}) {
    for (const double y : {0.01, 0.3, 0.9}) {
      EXPECT_LT(wide_line_error(convolved(cauchy(hardness)), y), 1e-27) << hardness << ", " << y;
    }
  }
}

/// Blobs 10¹⁵ times as large as the detail in them, with rays each that double precision cannot decide; the last two
/// are of convolved circles. Every seventh ray is judged with 113 bits
/// besides: where long double decides, both are the same.
TEST(WideReference, DecidesEveryRayOfBlobsWithFifteenDigitsBetweenTheirScales) {
  int compared = 0;
  for (const std::uint64_t seed : {802103, 810431, 810455, 810535, 820897, 825915}) {
    const SeededScaleCase seeded = seeded_scale_case(seed, 100);
    const scene::Database& database = seeded.made.database;
    render::TracerOptions options;
    options.pixel_angle = seeded.made.pixel_angle;
    const std::vector<render::Ray> rays = camera_rays(seeded.made.lines);
    const std::vector<render::Hit> hits = TracerUnderTest(database, options).hits(rays);
    const RoundingRule rule(database);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const render::Hit& hit = hits[i];
      const LineOfSight& line = seeded.made.lines[i];
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", ray " << i);
      EXPECT_EQ(hit.certainty, render::Certainty::certified);
      const Verdict verdict = rule.judge(rays[i], hit.is_miss() ? std::nullopt : std::optional(hit.t)).verdict;
      ASSERT_TRUE(verdict == Verdict::agrees || verdict == Verdict::undecided);
      if (verdict == Verdict::agrees && i % 7 != 0) continue;
      ++compared;
      const WideRoots wide = wide_roots(database, line);
      EXPECT_EQ(wide.touches, 0U);
      if (verdict == Verdict::agrees) {
        const RayRoots known = long_double_roots(database, line);
        ASSERT_EQ(wide.crossings.size(), known.crossings.size());
        for (std::size_t k = 0; k < known.crossings.size(); ++k) {
          EXPECT_LE(std::abs(wide.crossings[k].t - known.crossings[k].t),
                    known.crossings[k].slack + wide.crossings[k].slack + 0x1p-63L * known.crossings[k].t);
        }
        continue;
      }
      ASSERT_EQ(hit.is_miss(), wide.crossings.empty());
      if (hit.is_miss()) continue;
      // As the rule has it: the same place to eight units or, before it, one where F is within its rounding.
      const WideCrossing& first = wide.crossings.front();
      const long double units = 8 * 0x1p-52L * (line.origin.length() + first.t) + first.slack;
      EXPECT_LE(hit.t, first.t + units);
      EXPECT_TRUE(hit.t >= first.t - units || rule.excess(rays[i], hit.t) <= 1);
    }
  }
  EXPECT_GT(compared, 80);
}

/// Where double precision fails, the product answers in extended numbers of its own. A judge that shared them would
/// share their mistakes: answers that are made wrong on such rays must be told.
TEST(WideReference, TellsWrongAnswersOnRaysThatDoublePrecisionCannotDecide) {
  int moved = 0, missed = 0;
  for (const std::uint64_t seed : {802103, 810431, 820897}) {
    const SeededScaleCase seeded = seeded_scale_case(seed, 100);
    render::TracerOptions options;
    options.pixel_angle = seeded.made.pixel_angle;
    const std::vector<render::Ray> rays = camera_rays(seeded.made.lines);
    const std::vector<render::Hit> hits = TracerUnderTest(seeded.made.database, options).hits(rays);
    const RoundingRule rule(seeded.made.database);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (hits[i].is_miss()) continue;
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", ray " << i);
      for (const double factor : {1 - 1e-6, 1 + 1e-6}) {
        const Verdict verdict = rule.judge(rays[i], hits[i].t * factor).verdict;
        moved += verdict == Verdict::misplaced || verdict == Verdict::invented ? 1 : 0;
      }
      missed += rule.judge(rays[i], std::nullopt).verdict == Verdict::missed ? 1 : 0;
    }
  }
  EXPECT_GT(moved, 100);
  EXPECT_GT(missed, 50);
}

}  // namespace
}  // namespace isl::reference
