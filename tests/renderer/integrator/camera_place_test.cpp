#include "renderer/integrator/camera_place.h"

#include <gtest/gtest.h>

#include <vector>

namespace isl::render {
namespace {

using scene::Object;
using scene::Vec3;

scene::Transform shifted(const Vec3& by) {
  scene::Transform transform;
  transform.matrix.setTranslation(by);
  transform.inverse.setTranslation(-by);
  return transform;
}

/// Many copies of something with many parts, away from the camera, which stands in two balls.
class ManyObjects : public testing::Test {
 protected:
  static constexpr int kCopies = 1000, kParts = 100;

  ManyObjects() {
    scene::Group parts{.operation = scene::Operation::merge};
    for (int i = 0; i < kParts; ++i) parts.children.push_back(ball({0.1 * i, 0, 0}, 0.2));
    database_.groups.push_back(parts);
    Object whole;
    whole.kind = Object::Kind::group;
    whole.shape = 0;
    for (int i = 0; i < kCopies; ++i) {
      whole.parent_from_object = shifted({0, 10.0 + i, 0});
      database_.objects.push_back(whole);
    }
    database_.camera = scene::Camera{};
    database_.camera->location = Vec3(0);
  }
  Object ball(const Vec3& centre, double radius) {
    database_.solids.push_back({.a = centre, .radius_a = radius});
    Object object;
    object.shape = static_cast<std::uint32_t>(database_.solids.size() - 1);
    return object;
  }

  scene::Database database_;
};

TEST_F(ManyObjects, away_from_the_camera_are_hardly_asked) {
  // The axis of sorting is y: the lower ball comes first.
  database_.objects.push_back(ball({0, 1, 0}, 2));
  database_.objects.push_back(ball({0, -1, 0}, 2));
  const Tracer tracer(database_, {});
  StepCounter steps(kCopies * kParts / 10);
  const std::vector<Body> bodies = bodies_around_camera(database_, tracer, steps);
  EXPECT_FALSE(steps.is_spent());
  ASSERT_EQ(bodies.size(), 2u);
  std::vector<Body> placed;
  tracer.visit_objects([&](const PlacedObject& object) {
    if (object.object.kind == Object::Kind::solid) placed.push_back({object.body, object.interior, object.is_hollow});
  });
  ASSERT_EQ(placed.size(), 2u);
  EXPECT_EQ(bodies[0].id, placed[1].id);
  EXPECT_EQ(bodies[1].id, placed[0].id);
}

}  // namespace
}  // namespace isl::render
