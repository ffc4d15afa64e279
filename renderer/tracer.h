// Rays against a compiled scene: the seam between finding surfaces (fields, grid, solvers, solids) and making pictures of
// them (shading, effects, image). Rays come in batches, so that the inside may choose its own order and vector width.
#pragma once

#include "renderer/scene/database.h"
#include "renderer/solvers/paper_switches.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace isl::render {

using scene::Vec3;

struct Face;  // csg/face.h

/// Number of an instance: one placed solid or blob of the flattened scene. scene::kNone is "none".
using InstanceId = std::uint32_t;

/// The surface a secondary ray starts on, so that its root at t = 0 is known and not searched for.
struct RayStart {
  InstanceId instance = scene::kNone;
  std::uint8_t part = 0;  ///< of a solid: which of its surfaces (Hit::part)
  std::uint32_t leaf = scene::kNone;  ///< of a combination of solids and blobs: which of these (Hit::leaf)
};

/// What rays are traced for. Objects may be hidden from some kinds; the values are bits, so that one number says which.
enum class RayKind : std::uint8_t {
  image = 1,       ///< from the camera, with no reflection on the way
  reflection = 2,  ///< with a reflection on the way from the camera
  shadow = 4,
  query = 0,  ///< of a question about the scene: meets all
};

/// A half-line in world space. The direction has unit length. A ray with NaN or infinite entries, or a zero direction,
/// meets nothing.
struct Ray {
  Vec3 origin;
  Vec3 direction;
  double t_max = std::numeric_limits<double>::infinity();  ///< beyond it nothing counts (a light's distance)
  double path_length = 0;  ///< from the eye to the origin; with the pixel's angle it gives the footprint
  RayStart start;
};

/// The nearest surface. `instance` is scene::kNone for a miss.
struct Hit {
  double t = std::numeric_limits<double>::infinity();
  InstanceId instance = scene::kNone;
  std::uint32_t cell = scene::kNone;  ///< of a blob: the cell whose list holds every component that matters at the hit;
                                      ///< of `paper` and `iso` with reuse, a number known to the thread that found it
  std::uint8_t part = 0;              ///< of a solid: which of its surfaces
  bool from_inside = false;           ///< the ray came out of the solid rather than into it
  std::uint32_t leaf = scene::kNone;  ///< of a combination of solids and blobs: which of these

  [[nodiscard]] bool is_miss() const { return instance == scene::kNone; }
  /// For a ray that goes on from here.
  [[nodiscard]] RayStart start() const { return {instance, part, leaf}; }
};

/// Where on a shape a point is: what its coordinates (u, v) follow from.
struct SurfacePlace {
  scene::Object::Kind kind = scene::Object::Kind::solid;  ///< solid or blob
  std::uint32_t shape = scene::kNone;                     ///< index into the database's solids or blobs
  std::uint32_t component = 0;                            ///< of a blob: index into its components
  Vec3 point{0};                                          ///< in the shape's space
};

/// A texture and its share of the material at a point; the shares of a point add up to one. The components of a blob that
/// have a texture in common share it, unless it asks where on each component the point is.
struct TextureShare {
  scene::TextureId texture;
  double weight;
  Vec3 place{0};  ///< the point, in the space that the texture lives in
  SurfacePlace surface{};
};

struct SurfacePoint {
  Vec3 position;
  Vec3 normal;  ///< outward, unit length, in world space
  std::vector<TextureShare> textures;  ///< never empty; reused by the caller, so that nothing is allocated per point
};

/// Work done, for --stats. Merged over threads; sums do not depend on their order.
struct TraceCounters {
  std::uint64_t field_evaluations = 0;
  std::uint64_t uncertified_steps = 0;
  std::uint64_t cells = 0;
  std::uint64_t shading_evaluations = 0;  ///< of fields at points found, for normals and textures

  TraceCounters& operator+=(const TraceCounters& other) {
    field_evaluations += other.field_evaluations;
    uncertified_steps += other.uncertified_steps;
    cells += other.cells;
    shading_evaluations += other.shading_evaluations;
    return *this;
  }
};

enum class SolverName : std::uint8_t { hermite, paper, exact, iso, interval, lg, march, climb, sphere, segment, inclusion };

/// Whether it is the published solver or one of its kin, which has its switches.
[[nodiscard]] inline bool is_published(SolverName name) { return name == SolverName::paper || name == SolverName::iso; }

/// Whether it is another way of finding a root in a cell, for comparison (solvers/rival_solver-inl.h).
[[nodiscard]] inline bool is_rival(SolverName name) { return name >= SolverName::interval; }

/// A length along the ray: in pixels of the ray's own footprint, or in scene units.
struct Tolerance {
  double value = 0.05;
  bool in_pixels = true;

  friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

struct TracerOptions {
  SolverName solver = SolverName::hermite;
  int interpolants = 2;          ///< of `paper:K`
  PaperSwitches paper;           ///< of `paper` and `iso`
  Tolerance tolerance;
  Tolerance step{1, true};       ///< of those that march
  double relaxation = 1;         ///< of sphere tracing, in [1, 2)
  bool octree = false;           ///< of `lg`: cells culled as its authors have it, instead of those of all solvers
  double pixel_angle = 1e-3;     ///< radians a pixel subtends at the eye, for tolerances in pixels
  bool packets = true;           ///< of the product: rays in packets of eight, not one by one
  bool skeleton = false;         ///< every blob as its skeleton model (scene::Blob::is_skeleton)
  std::string simd;              ///< "" for the best the machine has, or a Highway target name ("AVX2")
};

/// A database made ready to be traced. Immutable; every member may be called from many threads.
class Tracer {
 public:
  Tracer(const scene::Database& database, const TracerOptions& options);
  ~Tracer();
  Tracer(Tracer&&) noexcept;

  /// hits[i] becomes the first surface that rays[i] meets with 0 < t < t_max. With the switch `reuse` of the published
  /// solver, the thread may ask for surfaces (surface_at) of the hits until it asks for hits again, and no other may.
  void first_hits(std::span<const Ray> rays, std::span<Hit> hits, TraceCounters& counters,
                  RayKind kind = RayKind::image) const;

  /// occluded[i] becomes 1 if anything that throws a shadow lies on rays[i] with 0 < t < t_max, else 0.
  void occlusions(std::span<const Ray> rays, std::span<std::uint8_t> occluded, TraceCounters& counters) const;

  /// Normal and materials where `ray` meets `hit`. Precondition: the hit is none of a miss.
  void surface_at(const Ray& ray, const Hit& hit, SurfacePoint& point, TraceCounters& counters) const;
  void surface_at(const Ray& ray, const Hit& hit, SurfacePoint& point) const {
    TraceCounters unread;
    surface_at(ray, hit, point, unread);
  }

  /// The face that was hit, at a point of the surface or near it, and how far rounding may have moved it. `reach` is
  /// the point's (csg/face.h).
  [[nodiscard]] Face face_at(const Hit& hit, const Vec3& point, const Vec3& reach) const;

  /// Whether this machine and program have the named vector target ("AVX3", "AVX2", "SSE4", …).
  [[nodiscard]] static bool has_simd_target(const std::string& name);

  [[nodiscard]] std::size_t grid_bytes() const;
  [[nodiscard]] std::string grid_json() const;  ///< for `isl dump --stage grid`
  [[nodiscard]] const char* simd_target() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace isl::render
