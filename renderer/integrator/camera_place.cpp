#include "renderer/integrator/camera_place.h"

#include "renderer/extents/extents.h"
#include "renderer/film/camera_functions.h"
#include "renderer/queries/insides.h"

#include <algorithm>
#include <limits>

namespace isl::render {
namespace {

/// Tells which objects the camera stands in. As in POV-Ray, an object holds nothing beyond the box around its surface,
/// if that is finite. Otherwise each disc, which bounds a half-space in combinations of solids, would keep the air out
/// of half of the world.
class CameraPlace {
 public:
  CameraPlace(const scene::Database& database, StepCounter& steps)
      : insides_(database), extents_(database), eye_(eye_of(database)), steps_(steps) {}

  [[nodiscard]] bool is_in(const scene::Object& object) {
    if (!insides_.is_inside(object, eye_, steps_)) return false;
    const Imath::Box3d box = box_of(object);
    return !is_finite(box) || box.intersects(eye_);
  }
  /// The box around its surface.
  [[nodiscard]] Imath::Box3d box_of(const scene::Object& object) { return extents_.of(object); }

 private:
  Insides insides_;
  Extents extents_;
  scene::Vec3 eye_;
  StepCounter& steps_;
};

/// The axis along which POV-Ray 3.7 sorts the boxes of finite objects (`find_axis` of its bbox.cpp): that with the
/// largest distance from the least lower end to the lower end of the last box that ends beyond the one that was kept
/// before.
class SortingAxis {
 public:
  void add(const Imath::Box3d& box) {
    for (int i = 0; i < 3; ++i) {
      low_[i] = std::min(low_[i], box.min[i]);
      if (box.max[i] > high_[i]) high_[i] = box.min[i];
    }
  }
  [[nodiscard]] int axis() const {
    const scene::Vec3 size = high_ - low_;
    return static_cast<int>(std::max_element(&size.x, &size.x + 3) - &size.x);
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::max();
  scene::Vec3 low_{kFar}, high_{-kFar};
};

}  // namespace

bool is_camera_in_solid(const scene::Database& database, StepCounter& steps) {
  CameraPlace place(database, steps);
  return std::ranges::any_of(database.objects,
                             [&](const scene::Object& object) { return !object.hollow && place.is_in(object); });
}

std::vector<Body> bodies_around_camera(const scene::Database& database, const Tracer& tracer, StepCounter& steps) {
  struct Around {
    Body body;
    scene::Vec3 middle;  ///< of its box; before all others if it goes on without end
  };
  // With fewer objects POV-Ray makes no tree.
  constexpr std::size_t kFewestOfTree = 3;
  std::vector<Around> around;
  std::size_t objects = 0;
  CameraPlace place(database, steps);
  tracer.visit_objects([&](const PlacedObject& placed) {
    ++objects;
    if (!place.is_in(placed.object)) return;
    const Imath::Box3d box = place.box_of(placed.object);
    const scene::Vec3 before_all(-std::numeric_limits<double>::infinity());
    around.push_back({{placed.body, placed.interior, placed.is_hollow}, is_finite(box) ? box.center() : before_all});
  });
  // The boxes of all objects take far longer than to find out that the camera is in none or one of them.
  if (around.size() > 1 && objects >= kFewestOfTree) {
    SortingAxis sorting;
    tracer.visit_objects([&](const PlacedObject& placed) {
      if (const Imath::Box3d box = place.box_of(placed.object); is_finite(box)) sorting.add(box);
    });
    std::ranges::stable_sort(around, {}, [axis = sorting.axis()](const Around& one) { return one.middle[axis]; });
  }
  std::vector<Body> bodies;
  for (const Around& one : around) bodies.push_back(one.body);
  return bodies;
}

}  // namespace isl::render
