// Finds which hits of a ray coincide with one another, or with the surface that the ray starts on.
//
// Faces of two instances that lie no farther apart than their rounding (face.h) coincide. Where the nearest hit
// coincides with others, the instance that was declared first shows. Such hits are kept while the nearest is searched
// for, and are compared with it in the end, so that the order in which instances are met decides nothing.
//
// Paths through clear bodies ask for all faces at the nearest hit, since a body is left there and another is entered.
// They are the faces that a ray from there would take for crossed (below), so that nothing is crossed twice or never.
//
// A ray that starts on a face knows its root and deflates it. A face of another instance that coincides with it there
// has been crossed too: the distance from the start to that face is t |n·d|, however far a grazing ray goes until it
// crosses. Where the surface bends, the greater of the slopes at the start and at the crossing counts, because the ray
// is no deeper in between. Earlier crossings of the same solid are passed as well: where the ray comes in through one
// side of a box just below the face it starts in and leaves through that face, it is no deeper than the rounding until
// then. So only the state behind the start counts: a ray that starts on a floor below a box is in the box, and meets
// its far side.
#pragma once

#include "renderer/rays/ray.h"
#include "renderer/solids/solid.h"
#include "renderer/trace/face.h"

#include <vector>

namespace isl::render {

/// Rays are known by their addresses, so they must stay where they are while they are asked about.
class RayFaces {
 public:
  /// With `keeps_all`, hits are kept that were declared behind the nearest one, too.
  RayFaces(const CompiledScene& scene, const BlobGradient& gradient, bool keeps_all)
      : scene_(scene), gradient_(gradient), keeps_all_(keeps_all) {}

  [[nodiscard]] bool keeps_all() const { return keeps_all_; }

  [[nodiscard]] const Spread& spread_of(InstanceId instance) const { return scene_.instances[instance].spread; }
  /// An upper bound of the rounding, in t, of a hit of the instance at t. It costs little.
  [[nodiscard]] double nearness(InstanceId instance, const Ray& ray, double t) const {
    return kNear * scene_.instances[instance].spread.at(reach_before(ray) + std::abs(t));
  }
  /// An upper bound of the coordinates that the ray's origin was added up from.
  [[nodiscard]] double reach_before(const Ray& ray) const {
    double reach = largest(ray.origin);
    if (ray.start.instance != scene::kNone) {
      reach += ray.path_length;
      reach += scene_.instances[ray.start.instance].spread.at(reach);
    }
    return reach;
  }

  /// The reach of a ray's origin. A start on a surface was found at the end of a path, and is as exact as that surface.
  [[nodiscard]] Vec3 reach_of(const Ray& ray);
  /// The reach in the instance's space.
  [[nodiscard]] Vec3 reach_in(InstanceId instance, const Ray& ray);

  [[nodiscard]] const BlobGradient& gradient() const { return gradient_; }

  /// True if the ray starts on the face that it crosses in `hit`.
  [[nodiscard]] bool is_at_start(const Ray& ray, const Hit& hit);
  /// The index of the first of a solid's crossings, from `first` on, behind the faces that the ray starts on.
  [[nodiscard]] std::size_t pass_start(InstanceId instance, const Ray& ray, const Crossings& found, std::size_t first);

  /// Keeps the farther of two hits if it may coincide with the nearer one.
  void keep_if_near(const Ray& ray, const Hit& nearer, const Hit& farther);
  [[nodiscard]] bool has_kept() const { return !kept_.empty(); }
  /// The hit that was declared first, among the nearest and the kept hits that coincide with it.
  [[nodiscard]] Hit first_declared(const Ray& ray, const Hit& nearest);
  /// The nearest hit and the kept hits on whose faces a ray begins that goes on from it, in the order of declaration.
  [[nodiscard]] std::vector<Hit> coinciding(const Ray& ray, const Hit& nearest);
  void forget() { kept_.clear(); }
  /// To be called before a ray moves or ends.
  void forget_reach() { reach_ray_ = nullptr; }

 private:
  struct Kept {
    const Ray* ray;
    Hit hit;
  };

  [[nodiscard]] static double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
  /// The face that a ray meets in a hit, at the ray's point t.
  [[nodiscard]] Face face_at(const Ray& ray, const Hit& hit, double t);

  const CompiledScene& scene_;
  BlobGradient gradient_;
  bool keeps_all_;
  std::vector<Kept> kept_;
  const Ray* reach_ray_ = nullptr;  ///< the ray that reach_of() was asked about last
  Vec3 reach_{0};
};

}  // namespace isl::render
