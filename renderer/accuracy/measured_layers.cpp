#include "renderer/accuracy/measured_layers.h"

#include "base/parallel.h"
#include "renderer/accuracy/measured_aovs.h"
#include "renderer/film/camera.h"
#include "renderer/scene/default_camera.h"

#include <algorithm>

namespace isl::render {
namespace {

/// The solver's share of the work, for progress alone: the reference takes some hundred times as long for a ray.
constexpr double kShareOfSolver = 0.02;

std::vector<Ray> rays_of(const scene::Database& database, const Image& image) {
  const scene::Camera camera = database.camera.value_or(scene::default_camera(image.full_width, image.full_height));
  const CameraRays view(camera, image.full_width, image.full_height, CameraFunctions::of(database));
  RecurringAngles angles;
  std::vector<Ray> rays;
  rays.reserve(image.window.area());
  for (int y = image.window.y0; y < image.window.y1; ++y) {
    for (int x = image.window.x0; x < image.window.x1; ++x) rays.push_back(view.through(x + 0.5, y + 0.5, angles));
  }
  return rays;
}

std::vector<const MeasuredAov*> asked_of(const Aovs& aovs) {
  std::vector<const MeasuredAov*> rows;
  for (const MeasuredAov& row : measured_aovs()) {
    if (std::ranges::find(aovs, &row.aov) != aovs.end()) rows.push_back(&row);
  }
  return rows;
}

}  // namespace

bool any_measured(const Aovs& aovs) { return !asked_of(aovs).empty(); }

std::size_t measuring_bytes(std::size_t pixels, const Aovs& aovs) {
  return any_measured(aovs) ? pixels * (sizeof(Ray) + sizeof(RayMeasure) + sizeof(ReferenceHit) + sizeof(RayError)) : 0;
}

std::optional<scene::Refusal> measure_layers(const scene::Database& database, const TracerOptions& options,
                                             const Tracer& tracer, const Aovs& aovs, int threads,
                                             const TellProgress& tell, Image& image) {
  const std::vector<const MeasuredAov*> rows = asked_of(aovs);
  if (rows.empty()) return std::nullopt;
  const StopFlag* const stop = options.run.stop;
  if (is_set(stop)) {  // the rays of a large picture alone take more than a moment
    for (const MeasuredAov* const row : rows) image.layers.emplace_back(row->aov, image.window.area());
    return std::nullopt;
  }
  std::optional<scene::Refusal> refusal;
  const std::vector<Ray> rays = rays_of(database, image);
  std::vector<RayMeasure> found(rays.size());
  std::vector<ReferenceHit> truth;
  const bool wants_errors = std::ranges::any_of(rows, &MeasuredAov::needs_reference);
  const double first_share = wants_errors ? kShareOfSolver : 1;
  const auto told = [&](double begin, double share) -> TellProgress {
    if (!tell) return {};
    return [&tell, begin, share](double done) { tell(begin + share * done); };
  };
  with_threads(threads > 0 ? threads : default_thread_count(), [&] {
    measure_each(tracer, rays, found, stop, told(0, first_share));
    if (!wants_errors) return;
    const ReferenceHits reference(database, options);
    refusal = reference.refusal();
    if (refusal) return;
    truth.resize(rays.size());
    reference.find(rays, truth, stop, told(first_share, 1 - first_share));
  });
  if (refusal) return refusal;
  std::vector<RayError> errors(rays.size());
  for (std::size_t i = 0; wants_errors && i < rays.size(); ++i) {
    errors[i] = error_of(rays[i], found[i], truth[i], options.pixel_angle);
  }
  for (const MeasuredAov* const row : rows) {
    Layer& layer = image.layers.emplace_back(row->aov, rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      row->fill(found[i], errors[i], layer.at(i));
      layer.round(i);
    }
  }
  return std::nullopt;
}

}  // namespace isl::render
