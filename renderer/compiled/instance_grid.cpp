#include "renderer/compiled/instance_grid.h"

#include "renderer/grid/grid_builder.h"
#include "renderer/solids/solid.h"

#include <cmath>
#include <limits>

namespace isl::render {
namespace {

/// False for a box that reaches too far for a grid: its instance is kept outside, like an endless one.
bool fits_in_grid(const Box& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(box.min[axis]) <= kFarthestInGrid && std::abs(box.max[axis]) <= kFarthestInGrid)) return false;
  }
  return true;
}

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
  const Box box = local_bounds(scene, instance);
  if (!instance.is_placed || box.isEmpty() || !fits_in_grid(box)) return box;
  Box world;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                 corner & 4 ? box.max.z : box.min.z);
    world.extendBy(instance.world_from_object.point(p));
  }
  // A corner that overflows is infinite or NaN; extendBy ignores NaN.
  return fits_in_grid(world) ? world : endless_box();
}

class BoxClassifier {
 public:
  explicit BoxClassifier(const std::vector<Box>& boxes) : boxes_(boxes) {}

  CellKind classify(const Box& box, std::span<const std::uint32_t> items, std::vector<std::uint32_t>& kept) const {
    kept.clear();
    for (const std::uint32_t item : items) {
      if (boxes_[item].intersects(box)) kept.push_back(item);
    }
    return kept.empty() ? CellKind::empty : CellKind::leaf;
  }

  static void list(const Box&, std::span<const std::uint32_t> kept, ListSink& lists) { lists.add(kept); }

  [[nodiscard]] Box item_bounds(std::uint32_t item) const { return boxes_[item]; }

  static double cost(std::span<const std::uint32_t> kept) { return static_cast<double>(kept.size()); }
  static std::size_t most_entries(std::span<const std::uint32_t> kept) { return kept.size(); }

  /// A cell smaller than its smallest item separates nothing, so it is not divided.
  [[nodiscard]] Division division(double size, const std::vector<std::uint32_t>& kept) const {
    if (kept.size() <= kShortList) return Division::none;
    double least = size;
    for (const std::uint32_t item : kept) {
      const Vec3 extent = boxes_[item].size();
      least = std::min(least, std::max({extent.x, extent.y, extent.z}));
    }
    return size > least ? Division::lists : Division::none;
  }

 private:
  static constexpr std::size_t kShortList = 3;
  const std::vector<Box>& boxes_;
};

}  // namespace

void build_instance_grid(CompiledScene& scene, GridBudget& budget, Meter& meter) {
  Charge working = meter.new_charge();
  if (!meter.grow(working, scene.instances.size() * (sizeof(Box) + 2 * sizeof(std::uint32_t)))) return;
  std::vector<Box> boxes(scene.instances.size());
  scene.bounds = {};
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    if (!meter.goes_on()) return;
    const Box box = world_bounds(scene, scene.instances[i]);
    if (box.isEmpty()) continue;  // a blob without a surface
    if (!fits_in_grid(box)) {
      scene.unbounded.push_back(i);
      continue;
    }
    boxes[i] = box;
    scene.bounds.extendBy(box);
    scene.bounded.push_back(i);
  }
  BoxClassifier classifier(boxes);
  GridBuilder builder(classifier, limit_of(budget, scene.bounded.size(), &meter), &meter);
  scene.grid = builder.build(scene.bounds, scene.bounded);
  if (!meter.goes_on()) return;
  scene.grid.shrink_to_fit();
  budget.spend(scene.bounded.size(), builder.cost());
}

}  // namespace isl::render
