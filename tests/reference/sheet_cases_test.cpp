// Convolved planes through the public tracer, with results in closed form.
#include "renderer/reference/reference_kernel.h"
#include "tests/reference/small_scenes.h"
#include "tests/reference/tracer_under_test.h"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

namespace isl::reference {
namespace {

using scene::Vec3;
using testing::IsEmpty;
using testing::SizeIs;

render::TracerOptions exact_solver() { return with(render::SolverName::exact, {1e-12, false}); }

std::vector<double> walk(const scene::Database& database, const Vec3& origin, const Vec3& direction) {
  return TracerUnderTest(database, exact_solver()).walk(origin, direction);
}

void expect_roots(const std::vector<double>& found, const std::vector<double>& expected, double tolerance) {
  ASSERT_THAT(found, SizeIs(expected.size()));
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "root " << i;
}

const scene::Kernel kSheets[] = {over_sheets(quartic(0.1)), over_sheets(quartic(4)),  over_sheets(quartic(500)),
                                 over_sheets(cauchy(0.1)),  over_sheets(cauchy(1)),   over_sheets(cauchy(4)),
                                 over_sheets(cauchy(60)),   over_sheets(cauchy(300)), over_sheets(cauchy(500))};

TEST(Sheet, HasASurfaceOnBothSidesAtItsRadius) {
  for (const scene::Kernel& kernel : kSheets) {
    SCOPED_TRACE(kernel.hardness);
    const scene::Database alone = one_blob(kernel, {sheet({7, 0, -3}, {0, 1, 0}, 0.5)});
    expect_roots(walk(alone, {0, 4, 0}, {0, -1, 0}), {3.5, 4.5}, 1e-13);
    expect_roots(walk(alone, {0, -400, 0}, {0, 1, 0}), {399.5, 400.5}, 1e-12);
    expect_roots(walk(alone, {0, 1, 0}, {0.8, -0.6, 0}), {0.5 / 0.6, 1.5 / 0.6}, 1e-13);
    // Lines from within, to one side, and away from the plane.
    expect_roots(walk(alone, {0, 0.25, 0}, {0, 1, 0}), {0.25}, 1e-13);
    expect_roots(walk(alone, {0, 0, 0}, {0, 1, 0}), {0.5}, 1e-13);
    expect_roots(walk(alone, {0, 0.25, 0}, {0, -1, 0}), {0.75}, 1e-13);
    EXPECT_THAT(walk(alone, {0, 0.6, 0}, {0, 1, 0}), IsEmpty());
  }
}

TEST(Sheet, IsNeverLeftAlongIt) {
  for (const scene::Kernel& kernel : kSheets) {
    SCOPED_TRACE(kernel.hardness);
    const scene::Database alone = one_blob(kernel, {sheet({0, 0, 0}, {0, 0, 1}, 0.5)});
    for (const double z : {-0.7, -0.499, -0.1, 0.0, 0.3, 0.501, 40.0})
      EXPECT_THAT(walk(alone, {1, 2, z}, {0.6, 0.8, 0}), IsEmpty()) << z;
    // Lines almost along the plane: they leave it far away, or never by the measure of any scene.
    expect_roots(walk(alone, {0, 0, 0}, {1, 0, 1e-9}), {5e8}, 1e-4);
    EXPECT_THAT(walk(alone, {0, 0, 0.25}, {1, 0, 1e-200}), IsEmpty());
  }
}

TEST(HalfSpace, IsLeftByAGrazingRayFromWhereAHardFieldIsSteepest) {
  for (const scene::Kernel& kernel : {cauchy(60), cauchy(300), cauchy(500), gaussian(500)}) {
    const scene::Database alone = one_blob(kernel, {half_space({0, 0, 0}, {0, 0, 1}, 0.5)});
    expect_roots(walk(alone, {0, 0, 0}, {1, 0, 1e-9}), {5e8}, 1e-4);
    expect_roots(walk(alone, {0, 0, 1e-7}, {1, 0, 1e-9}), {5e8 - 100}, 1e-4);
  }
}

TEST(Sheet, MapsAreMapsOfItsDistances) {
  for (const scene::Kernel& kernel : kSheets) {
    scene::Database mapped = one_blob(kernel, {sheet({1, 0, 0}, {1, 0, 0}, 0.5)});
    scene::Transform stretch;
    stretch.matrix.setScale(Vec3(3, 1, 0.5));
    stretch.inverse.setScale(Vec3(1 / 3.0, 1, 2));
    mapped.transforms.push_back(stretch);
    mapped.blobs[0].components[0].transform = scene::TransformId{0};
    expect_roots(walk(mapped, {-4, 5, 6}, {1, 0, 0}), {5.5, 8.5}, 1e-12);
  }
}

TEST(Sheet, AddsUpWithOthersAndWithWhatHasAnEnd) {
  for (const scene::Kernel& kernel : {over_sheets(quartic(4)), over_sheets(cauchy(4))}) {
    // Two sheets on one plane have their surface where φ = ½.
    const ReferenceKernel phi(kernel);
    long double low = 1, high = phi.support().hi();
    for (int i = 0; i < 70; ++i) (phi.value((low + high) / 2) > 0.5L ? low : high) = (low + high) / 2;
    const double half = 0.5 * static_cast<double>(std::sqrt(low));
    const scene::Component one = sheet({0, 0, 0}, {0, 1, 0}, 0.5), other = sheet({3, 0, 3}, {0, -1, 0}, 0.5);
    expect_roots(walk(one_blob(kernel, {one, other}), {0, 4, 0}, {0, -1, 0}), {4 - half, 4 + half}, 1e-13);
    // One sheet carves away all of another.
    scene::Component against = other;
    against.strength = -1;
    EXPECT_THAT(walk(one_blob(kernel, {one, against}), {0, 4, 0}, {0, -1, 0}), IsEmpty());
  }
  // A ball of the same kernel beside the sheet is met at its place, and the sheet behind it; so is a ball far in front.
  const scene::Kernel kernel = over_sheets(quartic(4));
  const scene::Database standing =
      one_blob(kernel, {sheet({0, 0, 0}, {0, 1, 0}, 0.25), point({0, 3, 0}, 0.5), point({0, 1000, 0}, 0.5)});
  expect_roots(walk(standing, {0, 2000, 0}, {0, -1, 0}), {999.5, 1000.5, 1996.5, 1997.5, 1999.75, 2000.25}, 1e-12);
  expect_roots(walk(standing, {9, 5, 0}, {0, -1, 0}), {4.75, 5.25}, 1e-13);
}

TEST(Sheet, OfASkeletonIsTheSlabThatItIsAlone) {
  scene::Database skeleton =
      one_blob(over_sheets(cauchy(3)), {sheet({0, 0, 0}, {0, 1, 0}, 0.5), sheet({0, 0.8, 0}, {0, 1, 0}, 0.5)});
  skeleton.blobs[0].is_unblended = true;
  expect_roots(walk(skeleton, {0, 4, 0}, {0, -1, 0}), {2.7, 4.5}, 1e-13);
}

TEST(Sheet, IsSeenByThePublishedSolverToo) {
  for (const scene::Kernel& kernel : {over_sheets(quartic(2)), over_sheets(cauchy(2))}) {
    const scene::Database alone = one_blob(kernel, {sheet({0, 0, 0}, {0, 1, 0}, 0.5)});
    render::TracerOptions options = with(render::SolverName::paper, {});
    options.interpolants = 64;
    const TracerUnderTest paper(alone, options);
    EXPECT_NEAR(paper.hit(camera_ray({{0, 4, 0}, {0, -1, 0}})).t, 3.5, 1e-5);
    EXPECT_NEAR(paper.hit(camera_ray({{0, 0, 0}, {0.6, 0.8, 0}})).t, 0.625, 1e-5);
    EXPECT_TRUE(paper.hit(camera_ray({{0, 0.25, 0}, {1, 0, 0}})).is_miss());
    EXPECT_TRUE(paper.hit(camera_ray({{0, 0.75, 0}, {1, 0, 0}})).is_miss());
  }
}

}  // namespace
}  // namespace isl::reference
