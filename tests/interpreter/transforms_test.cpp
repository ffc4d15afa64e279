#include "interpreter/transforms.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace isl::interpreter {
namespace {

using scene::Matrix;
using scene::Vec3;

void expect_near(const Vec3& a, const Vec3& b, double slack = 1e-12) {
  EXPECT_LT((a - b).length(), slack) << a << " and " << b;
}

TEST(Transforms, QuarterTurnsAreExactAndHavePovRaysSigns) {
  EXPECT_EQ(rotation({0, 90, 0}).point({0, 0, 1}), Vec3(1, 0, 0));
  EXPECT_EQ(rotation({0, 0, 90}).point({1, 0, 0}), Vec3(0, 1, 0));
  EXPECT_EQ(rotation({90, 0, 0}).point({0, 1, 0}), Vec3(0, 0, 1));
  EXPECT_EQ(rotation({0, 0, -450}).point({1, 0, 0}), Vec3(0, -1, 0));
}

RC_GTEST_PROP(Transforms, RotatingAVectorIsWhatTheMatrixDoes, (int x, int y, int z)) {
  const Vec3 degrees(x % 720 / 2.0, y % 720 / 2.0, z % 720 / 2.0), v(1, 2, 3);
  RC_ASSERT((rotated(v, degrees) - rotation(degrees).point(v)).length() < 1e-12);
  RC_ASSERT((rotation(degrees).inverse_point(rotated(v, degrees)) - v).length() < 1e-12);
}

TEST(Transforms, InverseUndoesAnAffineMap) {
  const Matrix matrix(1, 2, 3, 0, 0, 1, 4, 0, 5, 6, 0, 0, 7, 8, 9, 1);
  Matrix inverse;
  double condition = 0;
  ASSERT_TRUE(invert(matrix, inverse, condition));
  expect_near(scene::Transform{matrix, inverse}.inverse_point(scene::Transform{matrix, inverse}.point({1, -2, 3})),
              {1, -2, 3});
  EXPECT_GT(condition, 1);
}

TEST(Transforms, SingularMapsHaveNoInverseWhateverTheirScale) {
  Matrix inverse;
  double condition = 0;
  for (const double scale : {1e-9, 1.0, 1e9}) {
    const Matrix flat(scale, 0, 0, 0, 0, scale, 0, 0, scale, scale, 0, 0, 0, 0, 0, 1);
    EXPECT_FALSE(invert(flat, inverse, condition)) << scale;
    const Matrix full(scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1);
    EXPECT_TRUE(invert(full, inverse, condition)) << scale;
    EXPECT_NEAR(condition, 3, 1e-12);
  }
}

TEST(Transforms, ScalesLoseNoDigitsUnlessATurnFollows) {
  const auto uneven = scaling({1e6, 1, 1e-6});
  EXPECT_NEAR(condition_of(uneven) / 1e12, 1, 1e-6);
  EXPECT_LT(inverse_error(uneven), 1e-15);
  EXPECT_LT(inverse_error(scene::then(rotation({10, 20, 30}), uneven)), 1e-15);
  EXPECT_GT(inverse_error(scene::then(uneven, rotation({10, 20, 30}))), 1e-6);
}

TEST(Transforms, SimilaritiesAreKnownByTheirFactor) {
  const auto turned = scene::then(rotation({10, 20, 30}), scaling(Vec3(2)));
  EXPECT_NEAR(similarity_factor(turned.matrix), 2, 1e-14);
  EXPECT_NEAR(similarity_factor(scaling({-3, 3, 3}).matrix), 3, 1e-14);
  EXPECT_EQ(similarity_factor(scaling({1, 2, 1}).matrix), 0);
  const Matrix shear(1, 0.1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  EXPECT_EQ(similarity_factor(shear), 0);
}

}  // namespace
}  // namespace isl::interpreter
