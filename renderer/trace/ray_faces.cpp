#include "renderer/trace/ray_faces.h"

#include <algorithm>

namespace isl::render {

using scene::Object;

Vec3 RayFaces::reach_of(const Ray& ray) {
  if (&ray == reach_ray_) return reach_;
  reach_ray_ = &ray;
  reach_ = reach_at(Vec3(0), ray.origin, 1);
  if (ray.start.instance == scene::kNone) return reach_;
  reach_ += Vec3(ray.path_length);
  // The rounding of the start's face counts as a larger reach. A blob's gradient is not known there; its spread serves
  // instead.
  const Instance& instance = scene_.instances[ray.start.instance];
  const Object::Kind kind =
      instance.kind == Object::Kind::group ? scene_.trees[instance.shape].leaves[ray.start.leaf].kind : instance.kind;
  const Hit start{0, ray.start.instance, scene::kNone, ray.start.part, false, ray.start.leaf};
  const double of_start = kind == Object::Kind::blob
                              ? instance.spread.at(largest(reach_))
                              : face_of(scene_, start, ray.origin, reach_, gradient_).rounding / kRounding;
  reach_ += Vec3(of_start);
  return reach_;
}

Vec3 RayFaces::reach_in(InstanceId instance, const Ray& ray) {
  const Instance& own = scene_.instances[instance];
  return own.is_placed ? reach_through(own.world_from_object.inverse, reach_of(ray)) : reach_of(ray);
}

Face RayFaces::face_at(const Ray& ray, const Hit& hit, double t) {
  return face_of(scene_, hit, ray.origin + ray.direction * t, reach_at(reach_of(ray), ray.direction, hit.t), gradient_);
}

bool RayFaces::is_at_start(const Ray& ray, const Hit& hit) {
  const Face face = face_at(ray, hit, hit.t);
  if (hit.t * face.slope(ray.direction) > face.rounding) return false;
  return hit.t * face_at(ray, hit, 0).slope(ray.direction) <= face.rounding;
}

std::size_t RayFaces::pass_start(InstanceId instance, const Ray& ray, const Crossings& found, std::size_t first) {
  for (auto i = static_cast<std::size_t>(found.count); i > first; --i) {
    const Hit hit{found.t[i - 1], instance, scene::kNone, found.part[i - 1], false, scene::kNone};
    if (is_at_start(ray, hit)) return i;
  }
  return first;
}

void RayFaces::keep_if_near(const Ray& ray, const Hit& nearer, const Hit& farther) {
  const double most = nearness(nearer.instance, ray, farther.t) + nearness(farther.instance, ray, farther.t);
  if (farther.t - nearer.t <= most) kept_.push_back({&ray, farther});
}

std::vector<Hit> RayFaces::coinciding(const Ray& ray, const Hit& nearest) {
  std::vector<Hit> found{nearest};
  const Ray beyond = continued(ray, nearest);
  for (const Kept& kept : kept_) {
    if (kept.ray != &ray) continue;
    Hit there = kept.hit;
    there.t -= nearest.t;
    if (is_at_start(beyond, there)) found.push_back(kept.hit);
  }
  forget_reach();
  std::stable_sort(found.begin(), found.end(), [](const Hit& a, const Hit& b) { return a.instance < b.instance; });
  return found;
}

Hit RayFaces::first_declared(const Ray& ray, const Hit& nearest) {
  Hit first = nearest;
  for (const Kept& kept : kept_) {
    if (kept.ray != &ray || !(kept.hit.instance < first.instance)) continue;
    const double rounding =
        face_at(ray, nearest, nearest.t).along(ray.direction) + face_at(ray, kept.hit, kept.hit.t).along(ray.direction);
    if (kept.hit.t - nearest.t <= rounding) first = kept.hit;
  }
  return first;
}

}  // namespace isl::render
