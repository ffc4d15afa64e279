#include "renderer/accuracy/reference_hits.h"

#include "base/check.h"
#include "renderer/accuracy/ray_blocks.h"
#include "renderer/csg/expansion.h"
#include "renderer/reference/reference_tracer.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace isl::render {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// The objects of a scene, each with its place in the world: the blobs that stand for themselves, and all others. The
/// unions that are open are a list instead of recursion, so that depth costs no stack.
class Sorted {
 public:
  Sorted(const scene::Database& database, const Expansion& expansion) : database_(database), expansion_(expansion) {
    for (const scene::Object& object : database.objects) {
      add(object, {});
      while (!open_.empty()) {
        OpenUnion& innermost = open_.back();
        if (innermost.next == innermost.children->size()) {
          open_.pop_back();
        } else {
          const scene::Object& child = (*innermost.children)[innermost.next++];
          add(child, scene::Object(innermost.own));  // a copy, because opening the child moves the list
        }
      }
    }
  }

  std::vector<scene::Object> blobs, others;

 private:
  struct OpenUnion {
    const std::vector<scene::Object>* children;
    scene::Object own;
    std::size_t next = 0;
  };

  void add(const scene::Object& object, const scene::Object& above) {
    if (object.no_image || above.no_image) return;  // camera rays do not meet it
    // Groups of empty groups are as many as others.
    if (expansion_.instances(object, above.inverse) == 0) return;
    scene::Object own = object;
    own.parent_from_object = then(object.parent_from_object, above.parent_from_object);
    own.inverse = above.inverse != object.inverse;
    const bool is_whole = needs_csg(database_, object, above.inverse);
    if (object.kind == scene::Object::Kind::group && !is_whole) {
      open_.push_back({&database_.groups[object.shape].children, std::move(own)});
    } else {
      (object.kind == scene::Object::Kind::blob && !is_whole ? blobs : others).push_back(std::move(own));
    }
  }

  const scene::Database& database_;
  const Expansion& expansion_;
  std::vector<OpenUnion> open_;
};

reference::Line ray_in(const scene::Matrix& object_from_world, const Ray& ray) {
  using reference::interval_of;
  if (object_from_world == scene::Matrix()) return {interval_of(ray.origin), interval_of(ray.direction)};
  return {reference::transformed_point(interval_of(ray.origin), object_from_world),
          reference::transformed_vector(interval_of(ray.direction), object_from_world)};
}

reference::Box world_bounds(const reference::Box& box, const scene::Matrix& object_from_world) {
  return object_from_world == scene::Matrix() ? box : reference::box_before(box, object_from_world);
}

}  // namespace

ReferenceHits::ReferenceHits(const scene::Database& database, const TracerOptions& options) {
  using reference::ReferenceField;
  const auto drawn = options.unblended ? ReferenceField::Drawn::unblended : ReferenceField::Drawn::as_recorded;
  charge_ = Charge(options.run.budget);
  const Expansion expansion(database);
  if (!take_memory(database, expansion)) return;
  Sorted sorted(database, expansion);
  std::map<std::uint32_t, std::shared_ptr<const ReferenceField>> fields;
  std::vector<reference::Box> bounds;
  for (const scene::Object& object : sorted.blobs) {
    if (is_set(options.run.stop)) return;
    std::shared_ptr<const ReferenceField>& field = fields[object.shape];
    if (!field) field = std::make_shared<const ReferenceField>(database, database.blobs[object.shape], drawn);
    const scene::Matrix& object_from_world = object.parent_from_object.inverse;
    blobs_.push_back({field, object_from_world, world_bounds(field->bounds(), object_from_world)});
    bounds.push_back(blobs_.back().bounds);
  }
  bounds_ = reference::BoxTree(bounds);
  if (sorted.others.empty()) return;
  auto rest = std::make_unique<scene::Database>(database);
  rest->objects = std::move(sorted.others);
  rest_ = std::move(rest);
  TracerOptions exact = options;
  exact.solver = SolverName::exact;
  others_.emplace(*rest_, exact);
  refusal_ = others_->refusal();
}

bool ReferenceHits::take_memory(const scene::Database& database, const Expansion& expansion) {
  double bytes = 0;
  // Objects are in a list that grows to twice its size, and those that are no blobs in a copy of the database.
  for (const scene::Object& object : database.objects)
    bytes +=
        expansion.instances(object, false) * (3 * sizeof(scene::Object) + sizeof(Placed) + 4 * sizeof(reference::Box));
  // The formula of its skeleton and its matrix are pieces of their own, and so are the nodes of the tree of boxes.
  constexpr double kOfComponent = sizeof(reference::ReferenceComponent) + 1024;
  for (const scene::Blob& blob : database.blobs)
    bytes += static_cast<double>(blob.components.size()) * (kOfComponent + sizeof(scene::Component));
  constexpr double kMost = 0x1p62;
  if (charge_.grow(static_cast<std::size_t>(std::min(bytes, kMost)))) return true;
  refusal_ = {"the truth that errors are measured against would take more memory than the limit leaves",
              "`--max-memory` raises the limit"};
  return false;
}

ReferenceHit ReferenceHits::first_hit(const Ray& ray) const {
  ISL_CHECK(ray.start.instance == scene::kNone, "a ray from a surface");
  ReferenceHit nearest{kNever, 0, Knowledge::proven};
  if (others_) {
    Hit hit;
    TraceCounters unread;
    others_->first_hits(std::span(&ray, 1), std::span(&hit, 1), unread);
    if (!hit.is_miss()) nearest = {hit.t, 0, Knowledge::trusted};
  }
  const reference::RoughLine line({reference::interval_of(ray.origin), reference::interval_of(ray.direction)});
  std::vector<std::uint32_t> numbers;
  bounds_.along(line, numbers);
  std::vector<std::pair<double, std::uint32_t>> candidates;  // by the earliest place where a surface may be
  for (const std::uint32_t i : numbers) candidates.emplace_back(line.within(blobs_[i].bounds).begin, i);
  std::ranges::sort(candidates);
  double first_touch = kNever;
  for (const auto& [earliest, i] : candidates) {
    if (earliest > nearest.t) break;
    const reference::RayRoots roots =
        roots_along(*blobs_[i].field, ray_in(blobs_[i].object_from_world, ray),
                    {.t_max = std::min<long double>(nearest.t, ray.t_max), .first_only = true});
    if (!roots.touches.empty()) first_touch = std::min(first_touch, static_cast<double>(roots.touches.front().begin));
    if (roots.crossings.empty()) continue;
    const reference::Crossing& crossing = roots.crossings.front();
    const auto t = static_cast<double>(crossing.t);
    nearest = {t, static_cast<double>(crossing.slack) + 0x1p-53 * t, Knowledge::proven};
  }
  if (first_touch < nearest.t) nearest.knowledge = Knowledge::undecided;
  return nearest;
}

void ReferenceHits::find(std::span<const Ray> rays, std::span<ReferenceHit> hits, const StopFlag* stop,
                         const TellProgress& tell) const {
  ISL_CHECK(rays.size() == hits.size(), "{} {}", rays.size(), hits.size());
  // A ray takes up to some milliseconds here, so tasks are small and look at `stop` often enough.
  constexpr std::size_t kTogether = 64;
  in_blocks(rays.size(), kTogether, stop, tell, [&](std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) hits[i] = first_hit(rays[i]);
  });
}

ReferenceSummary summarise_reference(std::span<const Ray> rays, std::span<const ReferenceHit> hits,
                                     double pixel_angle) {
  ReferenceSummary summary{.rays = hits.size()};
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const ReferenceHit& hit = hits[i];
    switch (hit.knowledge) {
      case Knowledge::proven:
        ++summary.proven;
        if (!hit.is_miss())
          summary.worst_pixels =
              std::max(summary.worst_pixels, hit.slack / (pixel_angle * (rays[i].path_length + hit.t)));
        break;
      case Knowledge::trusted: ++summary.trusted; break;
      case Knowledge::undecided: ++summary.undecided; break;
    }
  }
  return summary;
}

}  // namespace isl::render
