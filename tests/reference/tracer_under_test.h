// A render::Tracer as the tests of this folder use it: in batches for the comparison, ray by ray for closed forms.
#pragma once

#include "renderer/trace/tracer.h"
#include "tests/reference/agreement.h"
#include "tests/reference/random_scenes.h"

#include <limits>
#include <utility>
#include <vector>

namespace isl::reference {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Options with this solver and tolerance, the rest as shipped.
[[nodiscard]] inline render::TracerOptions with(render::SolverName solver, render::Tolerance tolerance) {
  render::TracerOptions options;
  options.solver = solver;
  options.tolerance = tolerance;
  return options;
}

[[nodiscard]] inline render::Ray camera_ray(const LineOfSight& line) {
  return {line.origin, line.direction, kInfinity, 0, {}};
}

[[nodiscard]] inline std::vector<render::Ray> camera_rays(const std::vector<LineOfSight>& lines) {
  std::vector<render::Ray> rays;
  for (const LineOfSight& line : lines) rays.push_back(camera_ray(line));
  return rays;
}

class TracerUnderTest {
 public:
  explicit TracerUnderTest(const scene::Database& database, const render::TracerOptions& options = {})
      : tracer_(database, options), comparison_{options.tolerance, options.pixel_angle, 8} {}
  explicit TracerUnderTest(scene::Database&& database, const render::TracerOptions& options = {})
      : database_(std::move(database)),
        tracer_(database_, options),
        comparison_{options.tolerance, options.pixel_angle, 8} {}

  [[nodiscard]] TraceBatch trace() const {
    return [this](std::span<const render::Ray> rays, std::span<render::Hit> hits) {
      tracer_.first_hits(rays, hits, counters_);
    };
  }
  [[nodiscard]] OccludeBatch occlude() const {
    return [this](std::span<const render::Ray> rays, std::span<std::uint8_t> occluded) {
      tracer_.occlusions(rays, occluded, counters_);
    };
  }
  [[nodiscard]] std::vector<render::Hit> hits(const std::vector<render::Ray>& rays) const {
    std::vector<render::Hit> found(rays.size());
    trace()(rays, found);
    return found;
  }
  [[nodiscard]] render::Hit hit(const render::Ray& ray) const { return hits({ray}).front(); }

  [[nodiscard]] render::SurfacePoint surface(const render::Ray& ray, const render::Hit& hit) const {
    render::SurfacePoint point;
    tracer_.surface_at(ray, hit, point);
    return point;
  }

  /// Every surface along a line, each found by a ray that starts on the one before.
  [[nodiscard]] std::vector<double> walk(const scene::Vec3& origin, const scene::Vec3& direction,
                                         std::size_t at_most = 3000) const {
    std::vector<double> found;
    render::Ray ray = camera_ray({origin, direction});
    for (double travelled = 0; found.size() < at_most;) {
      const render::Hit next = hit(ray);
      if (next.is_miss()) break;
      travelled += next.t;
      found.push_back(travelled);
      ray = {surface(ray, next).position, direction, kInfinity, travelled, next.start()};
    }
    return found;
  }

  [[nodiscard]] const AgreementOptions& comparison() const { return comparison_; }
  /// The sum over all rays until now.
  [[nodiscard]] std::uint64_t uncertified_steps() const { return counters_.uncertified_steps; }
  /// The greatest number of steps that a ray took, and the number of rays whose bound ended them.
  [[nodiscard]] std::uint64_t most_ray_steps() const { return counters_.most_ray_steps; }
  [[nodiscard]] std::uint64_t spent_rays() const { return counters_.spent_rays; }
  [[nodiscard]] std::uint64_t field_evaluations() const { return counters_.field_evaluations; }

 private:
  scene::Database database_;  ///< the tracer's, if nobody else keeps it
  render::Tracer tracer_;
  mutable render::TraceCounters counters_;
  AgreementOptions comparison_;
};

/// From every surface that the eyes' rays meet, one ray to a light, which is the same for eight eyes, and one that
/// grazes: 1e-6 off the tangent plane, to either side. `scale` is that of the scene.
[[nodiscard]] inline std::vector<render::Ray> shadow_rays(const TracerUnderTest& tracer,
                                                          const std::vector<render::Ray>& eyes, double scale,
                                                          RandomSource& random) {
  const std::vector<render::Hit> hits = tracer.hits(eyes);
  std::vector<render::Ray> shadows, grazing;
  scene::Vec3 light(0);
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    if (i % 8 == 0) light = random.direction() * (5 * scale);
    if (hits[i].is_miss()) continue;
    const render::SurfacePoint point = tracer.surface(eyes[i], hits[i]);
    const double distance = (light - point.position).length();
    const render::RayStart start = hits[i].start();
    shadows.push_back({point.position, (light - point.position) / distance, distance, hits[i].t, start});
    const scene::Vec3 tangent = point.normal.cross(random.direction()).normalized();
    const double lift = random.below(2) == 0 ? 1e-6 : -1e-6;
    grazing.push_back({point.position, (tangent + point.normal * lift).normalized(), 5 * scale, hits[i].t, start});
  }
  shadows.insert(shadows.end(), grazing.begin(), grazing.end());
  return shadows;
}

}  // namespace isl::reference
