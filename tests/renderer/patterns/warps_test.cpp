#include "renderer/patterns/warp_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isl::render {
namespace {

using scene::Database;
using scene::MappingWarp;
using scene::Pattern;
using scene::Vec3;

Vec3 warped_by(const scene::Warp& warp, const Vec3& p) {
  Pattern pattern;
  pattern.warps = {warp};
  return warped(Database{}, pattern, p, PointTurbulence::yes);
}

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LT((a - b).length(), 1e-12) << a << " is not " << b; }

TEST(Warps, ThePointMeetsTheLastOneFirst) {
  Database database;
  scene::Transform twice, one_right;
  twice.matrix.setScale(Vec3(2));
  twice.inverse.setScale(Vec3(0.5));
  one_right.matrix.setTranslation(Vec3(1, 0, 0));
  one_right.inverse.setTranslation(Vec3(-1, 0, 0));
  database.transforms = {twice, one_right};
  Pattern pattern;
  pattern.warps = {scene::TransformId{0}, scene::TransformId{1}};
  expect_near(warped(database, pattern, {3, 0, 0}, PointTurbulence::yes), {1, 0, 0});
}

TEST(Warps, ASliceRepeatsAndIsMirrored) {
  scene::RepeatWarp repeat{.axis = 0, .width = 2, .flip = {1, 1, 0}};
  expect_near(warped_by(repeat, {0.5, 3, 4}), {0.5, 3, 4});
  expect_near(warped_by(repeat, {2.5, 3, 4}), {1.5, -3, 4});
  expect_near(warped_by(repeat, {-0.5, 3, 4}), {0.5, -3, 4});
  expect_near(warped_by(repeat, {4.5, 3, 4}), {0.5, 3, 4});
}

TEST(Warps, ABlackHoleReachesAsFarAsItsRadius) {
  const scene::BlackHoleWarp hole{.centre = {1, 0, 0}, .radius = 2, .strength = 1, .falloff = 1};
  expect_near(warped_by(hole, {3.5, 0, 0}), {3.5, 0, 0});
  expect_near(warped_by(hole, {2, 0, 0}), {2.5, 0, 0});
  scene::BlackHoleWarp inverse = hole;
  inverse.inverse = true;
  expect_near(warped_by(inverse, {2, 0, 0}), {1.5, 0, 0});
}

TEST(Warps, ABlackHoleIsMovedIntoItsBlockAndTheBlockGrowsAroundIt) {
  // The centre moves to 0.5, and in z the block ends behind the hole, at 1.12.
  const scene::BlackHoleWarp hole{
      .centre = {0.1, 0.5, 0.62}, .radius = 0.5, .strength = 1, .falloff = 1, .repeats = true, .repeat = {1, 1, 1}};
  const Vec3 within(0.75, 0.5, 0.62);
  expect_near(warped_by(hole, within), {0.875, 0.5, 0.62});
  for (const Vec3& block : {Vec3(1, 0, 0), Vec3(0, -2, 0), Vec3(0, 0, 1.12), Vec3(-3, 1, -2.24)})
    expect_near(warped_by(hole, within + block), Vec3(0.875, 0.5, 0.62) + block);
}

TEST(Warps, AroundASphereIsLongitudeLatitudeAndDistance) {
  const MappingWarp sphere{.shape = MappingWarp::Shape::sphere};
  expect_near(warped_by(sphere, {0, 0, 2}), {0.25, 0.5, 2});
  expect_near(warped_by(sphere, {0, -3, 0}), {0, 0, 3});
  expect_near(warped_by(sphere, Vec3(0)), Vec3(0));
}

TEST(Warps, TheSidesOfACubeLieSideBySide) {
  const MappingWarp cube{.shape = MappingWarp::Shape::cube};
  expect_near(warped_by(cube, {-2, 0, 0}), {1.0 / 8, 0.5, 2});
  expect_near(warped_by(cube, {0, 0, 2}), {3.0 / 8, 0.5, 2});
  expect_near(warped_by(cube, {2, 0, 0}), {5.0 / 8, 0.5, 2});
  expect_near(warped_by(cube, {0, 0, -2}), {7.0 / 8, 0.5, 2});
  expect_near(warped_by(cube, {0, 2, 0}), {3.0 / 8, 5.0 / 6, 2});
}

}  // namespace
}  // namespace isl::render
