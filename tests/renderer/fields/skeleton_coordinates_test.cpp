// (u, v) of every skeleton at points whose coordinates follow directly from its definition.
#include "renderer/fields/skeleton_coordinates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

using scene::Skeleton;
constexpr double kTiny = 1e-14;  // a few roundings of numbers of size 1

struct Made {
  scene::Database database;
  scene::Blob blob;
};

Made made(Skeleton skeleton, const Vec3& a, const Vec3& b, double radius_a = 0.5, double radius_b = 0.5) {
  Made result;
  result.database.kernels.push_back({scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 4});
  scene::Component c;
  c.skeleton = skeleton;
  c.a = a;
  c.b = b;
  c.radius_a = radius_a;
  c.radius_b = radius_b;
  result.blob.components.push_back(c);
  result.blob.origins.push_back({});
  return result;
}

void expect_coordinates(const Made& of, const Vec3& point, double u, double v) {
  const Coordinates found = skeleton_coordinates(of.database, of.blob, 0, point, Vec3(7, 8, 9));
  EXPECT_NEAR(found.u, u, kTiny) << point;
  EXPECT_NEAR(found.v, v, kTiny) << point;
}

/// (x, y, z) ↦ (−y, x, z): a rotation about z by 90°.
scene::Turn about_z() { return {Imath::M33d(0, 1, 0, -1, 0, 0, 0, 0, 1)}; }

TEST(SkeletonCoordinates, OfAPointAreThoseOfAGlobe) {
  const Made globe = made(Skeleton::point, {1, 2, 3}, {0, 0, 0});
  expect_coordinates(globe, {2, 2, 3}, 0, 0.5);
  expect_coordinates(globe, {1, 2, 4}, 0.25, 0.5);
  expect_coordinates(globe, {0.5, 2, 3}, 0.5, 0.5);
  expect_coordinates(globe, {1, 2, 2}, 0.75, 0.5);
  expect_coordinates(globe, {2, 3, 3}, 0, 0.75);
  expect_coordinates(globe, {1, 9, 3}, 0, 1);
  expect_coordinates(globe, {1, -9, 3}, 0, 0);
}

TEST(SkeletonCoordinates, OfASegmentRunFromEndToEndAndAround) {
  const Made limb = made(Skeleton::segment, {0, 1, 0}, {0, 5, 0});
  expect_coordinates(limb, {0.5, 1, 0}, 0, 0);
  expect_coordinates(limb, {0, 2, 0.5}, 0.25, 0.25);
  expect_coordinates(limb, {-0.5, 4, 0}, 0.75, 0.5);
  expect_coordinates(limb, {0, 5, -0.5}, 1, 0.75);
  expect_coordinates(limb, {0.1, 5.4, 0.1}, 1, 0.125);
  expect_coordinates(limb, {0.1, 0.6, 0.1}, 0, 0.125);
}

TEST(SkeletonCoordinates, AroundAnyAxisStartFromTheShortestTurnOfX) {
  // The turn from y to x takes x to −y and keeps z; that from y to z keeps x and takes z to −y; that from y to −y is a
  // turn about x.
  expect_coordinates(made(Skeleton::segment, {0, 0, 0}, {2, 0, 0}), {1, -0.5, 0}, 0.5, 0);
  expect_coordinates(made(Skeleton::segment, {0, 0, 0}, {2, 0, 0}), {1, 0, 0.5}, 0.5, 0.25);
  expect_coordinates(made(Skeleton::segment, {0, 0, 0}, {0, 0, 2}), {0.5, 0, 1}, 0.5, 0);
  expect_coordinates(made(Skeleton::segment, {0, 0, 0}, {0, 0, 2}), {0, -0.5, 1}, 0.5, 0.25);
  expect_coordinates(made(Skeleton::segment, {0, 2, 0}, {0, 0, 0}), {0.5, 1, 0}, 0.5, 0);
  expect_coordinates(made(Skeleton::segment, {0, 2, 0}, {0, 0, 0}), {0, 1, -0.5}, 0.5, 0.25);
}

TEST(SkeletonCoordinates, AroundAnAxisAreMeasuredByTwoUnitVectorsAcrossIt) {
  for (const Vec3& direction :
       {Vec3(1, 2, 3), Vec3(-1, -9, 2), Vec3(1e-9, -1, 0), Vec3(0, -1, 1e-200), Vec3(0, 1, 0)}) {
    const Vec3 axis = direction.normalized();
    const AcrossAxis across(axis);
    EXPECT_NEAR(across.x.length(), 1, kTiny) << direction;
    EXPECT_NEAR(across.z.length(), 1, kTiny) << direction;
    EXPECT_NEAR(across.x.dot(across.z), 0, kTiny) << direction;
    EXPECT_NEAR(across.x.dot(axis), 0, kTiny) << direction;
    EXPECT_NEAR((across.z.cross(across.x) - axis).length(), 0, kTiny) << direction;
  }
}

TEST(SkeletonCoordinates, OfAConeAreThoseOfTheNearestSphere) {
  // Radii of 2 and 1 at a distance of 4 give k = −1/4.
  const Made limb = made(Skeleton::cone, {0, 0, 0}, {0, 4, 0}, 2, 1);
  expect_coordinates(limb, {0, 2, 0}, 0.5, 0);
  // At the height 3 and the distance ρ = 1 from the axis, w = 2 − 3/4, and the sphere's centre is at 3 + kρ²/w.
  expect_coordinates(limb, {0, 3, 1}, 2.8 / 4, 0.25);
  expect_coordinates(limb, {1, -1, 0}, 0, 0);
  expect_coordinates(limb, {0, 6, 0}, 1, 0);
}

TEST(SkeletonCoordinates, OfACircleAreThoseOfPovraysTorus) {
  const Made ring = made(Skeleton::circle, {0, 0, 0}, {0, 1, 0}, 0.5, 2);
  expect_coordinates(ring, {2.5, 0, 0}, 0.5, 0.5);
  expect_coordinates(ring, {0, 0, 2.5}, 0.25, 0.5);
  expect_coordinates(ring, {0, 0, -2.5}, 0.75, 0.5);
  expect_coordinates(ring, {2, 0.5, 0}, 0.5, 0.75);
  expect_coordinates(ring, {2, -0.5, 0}, 0.5, 0.25);
}

TEST(SkeletonCoordinates, OfADiscRunFromItsCentreToItsRimAndAround) {
  const Made disc = made(Skeleton::disc, {0, 0, 0}, {0, 1, 0}, 0.5, 2);
  expect_coordinates(disc, {1, 0.3, 0}, 0.5, 0);
  expect_coordinates(disc, {0, -0.2, 0.5}, 0.25, 0.25);
  expect_coordinates(disc, {0, 0.1, -2.3}, 1, 0.75);
  expect_coordinates(disc, {0, 0.5, 0}, 0, 0);
}

TEST(SkeletonCoordinates, OfABoxAreThoseOfTheUnfoldedBox) {
  const Made box = made(Skeleton::box, {0, 0, 0}, {4, 3, 4});
  expect_coordinates(box, {-0.5, 1.5, 1}, 1 / 16.0, 0.5);
  expect_coordinates(box, {1, 1.5, 4.5}, 5 / 16.0, 0.5);
  expect_coordinates(box, {4.5, 1.5, 1}, 11 / 16.0, 0.5);
  expect_coordinates(box, {1, 1.5, -0.5}, 15 / 16.0, 0.5);
  expect_coordinates(box, {1, 3.5, 2}, 5 / 16.0, 5 / 6.0);
  expect_coordinates(box, {1, -0.5, 2}, 5 / 16.0, 1 / 6.0);
  // Round an edge, the coordinates are those of the edge on the face that the point is farther beyond; inside, those of
  // the nearest face.
  expect_coordinates(box, {-0.3, 3.4, 2}, 0.25, 5 / 6.0);
  expect_coordinates(box, {3.9, 1.5, 1}, 11 / 16.0, 0.5);
  // A box without thickness gives the nearer side.
  expect_coordinates(made(Skeleton::box, {0, 0, 0}, {4, 0, 4}), {1, 0.5, 2}, 5 / 16.0, 5 / 6.0);
}

TEST(SkeletonCoordinates, OfATriangleAreItsSharesOfBothSides) {
  Made sheet = made(Skeleton::triangle, {1, 0, 0}, {3, 0, 0});
  sheet.blob.corners.push_back({1, 0, 4});
  expect_coordinates(sheet, {1.5, 0.5, 1}, 0.25, 0.25);
  expect_coordinates(sheet, {1, -0.5, 0}, 0, 0);
  expect_coordinates(sheet, {3.4, 0.1, 0}, 1, 0);
  expect_coordinates(sheet, {1, 0, 4.3}, 0, 1);
  expect_coordinates(sheet, {2, 0.1, -0.4}, 0.5, 0);
}

TEST(SkeletonCoordinates, OfAPlaneAreLengthsAlongIt) {
  expect_coordinates(made(Skeleton::plane, {0, 3, 0}, {0, 1, 0}), {5, 3.5, -2}, 5, -2);
  expect_coordinates(made(Skeleton::plane, {3, 0, 0}, {1, 0, 0}), {3.5, -5, -2}, 5, -2);
}

TEST(SkeletonCoordinates, GoAlongWithTheTurnOfWhatIsBakedIn) {
  // The globe's pole y has become −x, its x axis y.
  Made globe = made(Skeleton::point, {1, 2, 3}, {0, 0, 0});
  globe.blob.turns.push_back(about_z());
  expect_coordinates(globe, {1, 3, 3}, 0, 0.5);
  expect_coordinates(globe, {0, 2, 3}, 0, 1);
  // A limb that was along x: a turn about y would put its start elsewhere, and a turn about z takes the start along.
  Made limb = made(Skeleton::segment, {0, 0, 0}, {0, 2, 0});
  limb.blob.turns.push_back(about_z());
  expect_coordinates(limb, {0.5, 1, 0}, 0.5, 0);
  // Mirrored in x, the angle runs the other way round.
  Made mirrored = made(Skeleton::segment, {0, 0, 0}, {0, 2, 0});
  mirrored.blob.turns.push_back({Imath::M33d(-1, 0, 0, 0, 1, 0, 0, 0, 1)});
  expect_coordinates(mirrored, {-0.5, 1, 0}, 0.5, 0);
  expect_coordinates(mirrored, {0, 1, 0.5}, 0.5, 0.25);
}

TEST(SkeletonCoordinates, GoAlongWithWhatIsNotBakedIn) {
  Made globe = made(Skeleton::point, {0, 0, 0}, {0, 0, 0});
  scene::Transform transform;
  transform.matrix.setScale(Vec3(2, 1, 1));
  transform.inverse.setScale(Vec3(0.5, 1, 1));
  globe.database.transforms.push_back(transform);
  globe.blob.components[0].transform = scene::TransformId{0};
  expect_coordinates(globe, {2, 0, 1}, 0.125, 0.5);
}

TEST(SkeletonCoordinates, OfPovraysOwnComponentsAreXAndYOfTheWorld) {
  Made globe = made(Skeleton::point, {1, 2, 3}, {0, 0, 0});
  globe.database.kernels[0] = {scene::KernelShape::quartic, scene::RadiusMeaning::support, 4};
  expect_coordinates(globe, {2, 2, 3}, 7, 8);
}

}  // namespace
}  // namespace isl::render
