// Which hits of a ray coincide: with one another, or with the surface that the ray starts on.
//
// Faces of two instances that lie no farther apart than their rounding (face.h) coincide. Where the nearest hit
// coincides with others, the instance that was declared first shows. Such hits are kept while the nearest is searched
// for, and are compared with it in the end, so that the order in which instances are met decides nothing.
//
// A ray that starts on a face knows its root and deflates it. A face of another instance that coincides with it there
// has been crossed too: the distance from the start to that face is t |n·d|, however far a grazing ray goes until it
// crosses. Where the surface bends, the greater slope of the start and the crossing counts: the ray is then no deeper
// in between. What the ray crosses of the same solid before is passed with it: where the ray comes in through one side
// of a box just below the face it starts in and leaves through that face, it is no deeper than the rounding until then.
// So only the state behind the start counts: below a box on a floor the ray is in the box, and meets its far side.
#pragma once

#include "renderer/rays/ray.h"
#include "renderer/solids/solid.h"
#include "renderer/trace/face.h"

#include <vector>

namespace isl::render {

/// Rays must stay where they are while they are asked about.
class RayFaces {
 public:
  RayFaces(const CompiledScene& scene, const BlobGradient& gradient) : scene_(scene), gradient_(gradient) {}

  /// A hit of the instance at t is rounded by no more than this, in t. Costs little.
  [[nodiscard]] double nearness(InstanceId instance, const Ray& ray, double t) const {
    double reach = largest(ray.origin);
    if (ray.start.instance != scene::kNone) {
      reach += ray.path_length;
      reach += scene_.instances[ray.start.instance].spread.at(reach);
    }
    return kNear * scene_.instances[instance].spread.at(reach + std::abs(t));
  }

  /// The reach of a ray's origin. A start on a surface was found at the end of a path and is as exact as that surface.
  [[nodiscard]] Vec3 reach_of(const Ray& ray);
  /// The same in the instance's space.
  [[nodiscard]] Vec3 reach_in(InstanceId instance, const Ray& ray);

  [[nodiscard]] const BlobGradient& gradient() const { return gradient_; }

  /// Whether the ray starts on the face that it crosses in `hit`.
  [[nodiscard]] bool is_at_start(const Ray& ray, const Hit& hit);
  /// The first of a solid's crossings, from `first` on, behind the faces that the ray starts on.
  [[nodiscard]] std::size_t pass_start(InstanceId instance, const Ray& ray, const Crossings& found, std::size_t first);

  /// Keeps the farther of two hits if it may coincide with the nearer one. Precondition: it was declared before.
  void keep_if_near(const Ray& ray, const Hit& nearer, const Hit& farther);
  [[nodiscard]] bool has_kept() const { return !kept_.empty(); }
  /// Of the kept hits that coincide with the nearest, and that itself, the one that was declared first.
  [[nodiscard]] Hit first_declared(const Ray& ray, const Hit& nearest);
  void forget() { kept_.clear(); }

 private:
  struct Kept {
    const Ray* ray;
    Hit hit;
  };

  [[nodiscard]] static double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
  /// The face that a ray meets in a hit, where the ray is at t.
  [[nodiscard]] Face face_at(const Ray& ray, const Hit& hit, double t);

  const CompiledScene& scene_;
  BlobGradient gradient_;
  std::vector<Kept> kept_;
  const Ray* reach_ray_ = nullptr;  ///< the last one that reach_of() was asked about
  Vec3 reach_{0};
};

}  // namespace isl::render
