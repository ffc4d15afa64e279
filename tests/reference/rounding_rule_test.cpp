// Tests of the rule of eight units, at a surface that lies where a support begins: before it F is next to flat, behind
// it a hard component is as steep as anything can be.
#include "tests/reference/rounding_rule.h"
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

namespace isl::reference {
namespace {

/// A ball 10⁷ times as large as what stands on it, whose field keeps just below the threshold along the ray, and a hard
/// small one, so that the surface lies where the support of the latter begins.
class BorderOfASupport : public testing::Test {
 protected:
  BorderOfASupport() {
    scene::Component small = point({0.5, 0.25, 0}, 1e-8);
    small.strength = 2;
    database_ = one_blob(quartic(500), {point({0, 0, kLarge * (1 + 1e-14)}, kLarge), small});
    const RayRoots roots = roots_along(ReferenceField(database_, database_.blobs.front()),
                                       {interval_of(ray_.origin), interval_of(ray_.direction)}, {});
    crossing_ = roots.crossings.front().t;
  }

  [[nodiscard]] Verdict judge(double t) const { return RoundingRule(database_).judge(ray_, t).verdict; }

  static constexpr double kLarge = 1e7;
  scene::Database database_;
  render::Ray ray_{{0.5, -0.25, 0}, {0, 1, 0}, std::numeric_limits<double>::infinity(), 0, {}};
  long double crossing_ = 0;
};

TEST_F(BorderOfASupport, IsWhereTheSurfaceLies) {
  const ReferenceField field(database_, database_.blobs.front());
  const FieldOnRay on_ray(field, {interval_of(ray_.origin), interval_of(ray_.direction)});
  const auto slope = [&](long double t) { return std::abs(on_ray.at(t).slope.magnitude()); };
  const long double eight_units = 8 * 0x1p-52L * 0.25L;
  EXPECT_LT(slope(crossing_ - eight_units), 1e-3L);
  EXPECT_GT(slope(crossing_ + eight_units), 1e3L);
}

TEST_F(BorderOfASupport, IsFoundWithinEightUnits) {
  const double exact = static_cast<double>(crossing_);
  EXPECT_EQ(judge(exact), Verdict::agrees);
  EXPECT_EQ(judge(std::nextafter(exact, 0)), Verdict::agrees);
  EXPECT_EQ(judge(std::nextafter(exact, 1)), Verdict::agrees);
}

TEST_F(BorderOfASupport, IsMisplacedBeyond) {
  const double exact = static_cast<double>(crossing_);
  EXPECT_EQ(judge(exact * (1 - 0x1p-46)), Verdict::misplaced);
  EXPECT_EQ(judge(exact * (1 + 0x1p-46)), Verdict::misplaced);
}

}  // namespace
}  // namespace isl::reference
