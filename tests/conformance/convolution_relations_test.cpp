// Relations between convolved fields, for every implementation: parts add up to the whole, a swapped kernel keeps the
// surface and its slope, and a transform moves a field as it moves its skeleton.
#include "renderer/reference/reference_kernel.h"
#include "tests/conformance/field_under_test.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace isl::conformance {
namespace {

using reference::RandomSource;

scene::Kernel with_mode(scene::Kernel kernel, scene::Skeleton skeleton) {
  return skeleton == scene::Skeleton::sheet ? reference::over_sheets(kernel) : reference::convolved(kernel);
}

/// Fields that are convolved, each with kernels of several hardnesses.
std::vector<FieldCase> convolved_cases() {
  std::vector<FieldCase> cases;
  for (const FieldCase& field : field_cases()) {
    if (field.kernel.mode != scene::FieldMode::distance && field.component.strength > 0) cases.push_back(field);
  }
  return cases;
}

class ConvolutionRelations : public testing::TestWithParam<Implementation> {
 protected:
  [[nodiscard]] static FieldUnderTest make(const FieldCase& field) { return GetParam().make(field); }
};

TEST_P(ConvolutionRelations, PartsOfASegmentAddUpToTheWhole) {
  RandomSource random(201);
  for (const FieldCase& whole : convolved_cases()) {
    if (whole.component.skeleton != scene::Skeleton::segment) continue;
    const Vec3 a = whole.component.a, b = whole.component.b;
    const double cuts[] = {0, random.between(0, 0.3), random.between(0.3, 0.9), 1};
    std::vector<FieldUnderTest> parts;
    for (int i = 0; i < 3; ++i) {
      FieldCase part = whole;
      part.component.a = i == 0 ? a : a + (b - a) * cuts[i];
      part.component.b = i == 2 ? b : a + (b - a) * cuts[i + 1];
      parts.push_back(make(part));
    }
    const FieldUnderTest tested = make(whole);
    for (int i = 0; i < 20; ++i) {
      const Vec3 p = random.in_ball(whole.reach);
      double sum = 0;
      Vec3 gradient(0);
      for (const FieldUnderTest& part : parts) {
        sum += part.value(p);
        gradient += part.gradient(p);
      }
      // The cuts are rounded, which turns the parts a little; the tolerance is 1e-12 of the field's size near its
      // surface.
      const double size = std::abs(tested.value(p)) + tested.gradient(p).length() + 1;
      EXPECT_NEAR(sum, tested.value(p), 1e-12 * size) << whole.name << " at " << p;
      EXPECT_LE((gradient - tested.gradient(p)).length(),
                1e-12 * (1 + whole.kernel.hardness) * size / whole.component.radius_a)
          << whole.name << " at " << p;
    }
  }
}

TEST_P(ConvolutionRelations, AnotherKernelOfTheSameHardnessKeepsValueAndSlopeAtTheRadius) {
  RandomSource random(202);
  for (const double hardness : {0.5, 1.0, 4.0, 60.0}) {
    for (const scene::Skeleton skeleton : {scene::Skeleton::segment, scene::Skeleton::sheet}) {
      const Vec3 normal = random.direction(), at = random.in_ball(1);
      const Vec3 along = (random.direction() - normal * random.between(0, 1)).cross(normal).normalized();
      for (const scene::Kernel& kernel : {reference::quartic(hardness), reference::cauchy(hardness)}) {
        // A segment that extends beyond its support in both directions is as good as endless.
        FieldCase field{
            "straight", reference::segment(at - along * 3, at + along * 3, 0.2), with_mode(kernel, skeleton), {}};
        if (skeleton == scene::Skeleton::sheet) field.component = reference::sheet(at, normal, 0.2);
        const double border = std::sqrt(static_cast<double>(reference::ReferenceKernel(field.kernel).support().hi()));
        ASSERT_LT(0.2 * border, 3);
        const FieldUnderTest tested = make(field);
        const Vec3 p = at + normal * 0.2;
        EXPECT_NEAR(tested.value(p), 1, 1e-12 * (1 + hardness));
        // Along the normal, q = (x/r)² has the slope 2/r at the radius.
        EXPECT_NEAR(tested.gradient(p).dot(normal) * 0.2 / 2 / hardness, -1, 1e-12 * (1 + hardness));
        EXPECT_LE((tested.gradient(p) - normal * tested.gradient(p).dot(normal)).length(), 1e-11 * (1 + hardness));
      }
    }
  }
}

TEST_P(ConvolutionRelations, ATransformOfTheComponentIsOneOfSpace) {
  RandomSource random(203);
  for (const FieldCase& plain : convolved_cases()) {
    if (plain.transform.matrix != scene::Matrix()) continue;
    const FieldUnderTest unmoved = make(plain);
    for (int repeat = 0; repeat < 3; ++repeat) {
      FieldCase moved = plain;
      moved.transform = reference::random_transform(random, 0.5);
      const FieldUnderTest tested = make(moved);
      for (int i = 0; i < 8; ++i) {
        const Vec3 p = random.in_ball(plain.reach);
        const double change = unmoved.gradient(p).length() * (1 + plain.reach);
        EXPECT_NEAR(tested.value(moved.transform.point(p)), unmoved.value(p),
                    1e-12 * (std::abs(unmoved.value(p)) + change + 1))
            << plain.name << " at " << p;
      }
    }
  }
}

TEST_P(ConvolutionRelations, MovingTheSkeletonIsMovingTheField) {
  RandomSource random(204);
  for (const FieldCase& plain : convolved_cases()) {
    if (plain.transform.matrix != scene::Matrix()) continue;
    // A rotation, an even scaling and a shift.
    const double factor = random.between(0.3, 3), angle = random.between(0, 3);
    scene::Transform similarity;
    similarity.matrix.setAxisAngle(random.direction(), angle);
    similarity.inverse = similarity.matrix.transposed();
    const Vec3 shift = random.in_ball(2);
    const auto turned = [&](const Vec3& v) { return similarity.vector(v); };
    const auto place = [&](const Vec3& v) { return turned(v) * factor + shift; };
    FieldCase moved = plain;
    moved.component.a = place(plain.component.a);
    const bool is_segment = plain.component.skeleton == scene::Skeleton::segment;
    moved.component.b = is_segment ? place(plain.component.b) : turned(plain.component.b).normalized();
    moved.component.radius_a *= factor;
    moved.component.radius_b *= factor;
    const FieldUnderTest unmoved = make(plain), tested = make(moved);
    for (int i = 0; i < 8; ++i) {
      const Vec3 p = random.in_ball(plain.reach);
      const double change = unmoved.gradient(p).length() * (1 + plain.reach + 2 / factor);
      EXPECT_NEAR(tested.value(place(p)), unmoved.value(p), 1e-12 * (std::abs(unmoved.value(p)) + change + 1))
          << plain.name << " at " << p;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fields, ConvolutionRelations, testing::ValuesIn(implementations()),
                         [](const auto& given) { return given.param.name; });

}  // namespace
}  // namespace isl::conformance
