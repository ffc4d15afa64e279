#include "renderer/compiled/instance_boxes.h"

#include "renderer/rays/ray.h"
#include "renderer/solids/solid.h"

#include <algorithm>
#include <limits>

namespace isl::render {
namespace {

Box local_bounds(const CompiledScene& scene, const Instance& instance) {
  switch (instance.kind) {
    case scene::Object::Kind::blob: return scene.blobs[instance.shape].bounds();
    case scene::Object::Kind::group: return scene.trees[instance.shape].bounds;
    case scene::Object::Kind::solid: break;
  }
  return bounds(scene.solids[instance.shape], scene.details);
}

Box endless_box() {
  const Vec3 far(std::numeric_limits<double>::infinity());
  return Box(-far, far);
}

Box world_bounds(const CompiledScene& scene, const Instance& instance) {
  Box box = local_bounds(scene, instance);
  if (!instance.is_placed || !fits_in_tree(box)) return box;
  Box world;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                 corner & 4 ? box.max.z : box.min.z);
    world.extendBy(instance.world_from_object.point(p));
  }
  // A corner that overflows is infinite or NaN; extendBy ignores NaN.
  return fits_in_tree(world) ? world : endless_box();
}

double surface(const Box& box) {
  const Vec3 size = box.size();
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// True if a list is quicker than a tree: every blob's grid has a box of its own.
bool are_few_blobs(const CompiledScene& scene, const std::vector<std::uint32_t>& instances) {
  constexpr std::size_t kFew = 3;
  return instances.size() <= kFew && std::ranges::all_of(instances, [&](std::uint32_t i) {
           return scene.instances[i].kind == scene::Object::Kind::blob;
         });
}

}  // namespace

void build_instance_boxes(CompiledScene& scene, Meter& meter) {
  Charge working = meter.new_charge();
  if (!meter.grow(working, scene.instances.size() * (sizeof(Box) + 2 * sizeof(std::uint32_t)))) return;
  std::vector<Box> boxes(scene.instances.size());
  scene.bounds = {};
  double surfaces = 0;
  std::vector<std::uint32_t> bounded;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    if (!meter.goes_on()) return;
    const Box box = world_bounds(scene, scene.instances[i]);
    if (box.isEmpty()) continue;  // a blob without a surface
    if ((scene.instances[i].hidden_from & kOnlyOpaque) != 0) scene.clear_bounds.extendBy(box);
    if (!fits_in_tree(box)) {
      scene.listed.push_back(i);
      continue;
    }
    boxes[i] = box;
    surfaces += surface(box);
    scene.bounds.extendBy(box);
    bounded.push_back(i);
  }
  if (bounded.empty()) return;
  // A convex body that lies in another is met by this share of the lines that meet the outer one (Crofton).
  const double whole = surface(scene.bounds);
  scene.crowd = whole > 0 ? surfaces / whole : static_cast<double>(bounded.size());
  if (are_few_blobs(scene, bounded)) {
    scene.listed.insert(scene.listed.end(), bounded.begin(), bounded.end());
    return;
  }
  // The list of nodes doubles as it grows, so that it may take twice their memory meanwhile.
  scene.boxes = build_box_tree(boxes, bounded, [&] { return meter.grow(working, 2 * sizeof(BoxNode)); });
}

}  // namespace isl::render
