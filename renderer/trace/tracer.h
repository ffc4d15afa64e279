// Rays against a compiled scene: the boundary between finding surfaces (fields, grid, solvers, solids) and making
// pictures of them (shading, effects, image). Rays come in batches, so that the tracer may choose its own order and
// vector width.
#pragma once

#include "renderer/rays/blob_fields.h"
#include "renderer/rays/light_group.h"
#include "renderer/rays/ray.h"
#include "renderer/rays/surface_point.h"
#include "renderer/rays/trace_counters.h"
#include "renderer/rays/tracer_options.h"
#include "renderer/scene/database.h"
#include "renderer/scene/refusal.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isl::render {

struct Face;  // trace/face.h

/// An object, or a part of a union, in the world.
struct PlacedObject {
  scene::Object object;
  BodyId body;
  scene::InteriorId interior;
  bool is_hollow;
};

/// A database made ready to be traced. Immutable; every member may be called from many threads.
class Tracer {
 public:
  /// The database must outlive the tracer. Precondition: the program has options.simd.
  Tracer(const scene::Database& database, const TracerOptions& options);
  ~Tracer();
  Tracer(Tracer&&) noexcept;

  /// The same compiled scene with another bound of what a ray takes in a blob.
  [[nodiscard]] Tracer with_ray_steps(std::uint64_t most) const;
  [[nodiscard]] std::uint64_t ray_steps() const { return ray_steps_; }

  /// The reason why the scene cannot be traced: it takes more memory than the run allows, or its solver's module cannot
  /// be loaded; null if it can. A scene that is refused, or whose run was stopped while it was compiled, has nothing in
  /// it.
  [[nodiscard]] const std::optional<scene::Refusal>& refusal() const;

  /// hits[i] becomes the first surface that rays[i] meets with 0 < t < t_max. With the switch `reuse` of the published
  /// solver, only the thread that found the hits may ask for their surfaces (surface_at), and only until it asks for
  /// hits again. If the run is stopped meanwhile, the rest stays as it is.
  ///
  /// If `coinciding` is given, it gets, ray by ray, all faces that a ray crosses where it meets the first, in the order
  /// of declaration, if they are several, or another than hits[i], and all of them may let light through. A face that
  /// is crossed back and forth there is left out.
  void first_hits(std::span<const Ray> rays, std::span<Hit> hits, TraceCounters& counters,
                  RayKind kind = RayKind::image, std::vector<CoincidingHit>* coinciding = nullptr) const;

  /// occluded[i] becomes an Occlusion: whether anything that throws a shadow lies on rays[i] with 0 < t < t_max.
  void occlusions(std::span<const Ray> rays, std::span<std::uint8_t> occluded, TraceCounters& counters,
                  RayKind kind = RayKind::shadow) const;

  /// False if the ray meets nothing that may let light through, which costs little to tell.
  [[nodiscard]] bool may_meet_clear(const Ray& ray) const;
  /// Tells of all objects, in the order of the scene.
  void visit_objects(const std::function<void(const PlacedObject&)>& visit) const;

  /// Normal and materials where `ray` meets `hit`. Precondition: the hit is not a miss.
  void surface_at(const Ray& ray, const Hit& hit, SurfacePoint& point, TraceCounters& counters) const;
  /// The same, with what set_blob_fields() told.
  void surface_at(const Ray& ray, const Hit& hit, const BlobFields& fields, SurfacePoint& point,
                  TraceCounters& counters) const;
  /// Sets fields[k] to those of the blob that is hit by ray number which[k], at the point where it is hit. To ask for
  /// many hits at once takes less time than one by one. Where a surface depends on more than this, fields[k] stays.
  void set_blob_fields(std::span<const Ray> rays, std::span<const Hit> hits, std::span<const std::uint32_t> which,
                       std::span<BlobFields> fields, TraceCounters& counters) const;
  void surface_at(const Ray& ray, const Hit& hit, SurfacePoint& point) const {
    TraceCounters unread;
    surface_at(ray, hit, point, unread);
  }

  /// The light groups of the world, each as often as it is placed.
  [[nodiscard]] std::span<const LightGroup> light_groups() const;
  /// The light group that the object of a hit, which is no miss, belongs to: its index, or kNone.
  [[nodiscard]] std::uint32_t light_group_of(const Hit& hit) const;

  /// True if rays of the kind do not meet the object of a hit, which is no miss.
  [[nodiscard]] bool is_hidden(const Hit& hit, RayKind kind) const;

  /// The statement that made the object of a hit, which is no miss.
  [[nodiscard]] OriginId origin_of(const Hit& hit) const;

  /// The face that was hit, at a point of the surface or near it, and how far rounding may have moved it. `reach` is
  /// the point's (trace/face.h).
  [[nodiscard]] Face face_at(const Hit& hit, const Vec3& point, const Vec3& reach) const;

  /// The reason why this program has no such solver (lower case, no full stop) and what to do, or "". A rival's module
  /// is loaded here.
  [[nodiscard]] static std::string problem_of(SolverName solver);

  /// True if this machine and program have the named vector target ("AVX3", "AVX2", "SSE4", …).
  [[nodiscard]] static bool has_simd_target(const std::string& name);

  [[nodiscard]] std::size_t grid_bytes() const;
  [[nodiscard]] std::string grid_json() const;  ///< for `isl dump --stage grid`
  [[nodiscard]] const char* simd_target() const;

 private:
  /// Gives a point that is seen from inside the texture of the inside, if there is one. `local` is the point in the
  /// instance's space.
  void set_interior_texture(const Hit& hit, const Vec3& local, SurfacePoint& point) const;

  struct Impl;
  Tracer(std::shared_ptr<Impl> impl, std::uint64_t ray_steps);

  std::shared_ptr<Impl> impl_;
  std::uint64_t ray_steps_;  ///< in the place of those of the settings
};

}  // namespace isl::render
