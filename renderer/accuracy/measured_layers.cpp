#include "renderer/accuracy/measured_layers.h"

#include "base/parallel.h"
#include "renderer/accuracy/ray_errors.h"
#include "renderer/film/camera.h"
#include "renderer/scene/default_camera.h"

#include <limits>

namespace isl::render {
namespace {

std::vector<Ray> rays_of(const scene::Camera& camera, const Image& image) {
  const CameraRays view(camera, image.full_width, image.full_height);
  std::vector<Ray> rays;
  rays.reserve(image.window.area());
  for (int y = image.window.y0; y < image.window.y1; ++y) {
    for (int x = image.window.x0; x < image.window.x1; ++x) rays.push_back(view.through(x + 0.5, y + 0.5));
  }
  return rays;
}

void set_costs(std::span<const RayMeasure> found, const Aovs& aovs, Layers& layers) {
  for (const RayMeasure& ray : found) {
    if (aovs.cost) layers.cost.insert(layers.cost.end(), {static_cast<float>(ray.field_evaluations), ray.seconds});
    if (aovs.solver_steps) layers.solver_steps.push_back(ray.solver_steps);
  }
}

void set_errors(std::span<const RayError> errors, const Aovs& aovs, Layers& layers) {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  for (const RayError& error : errors) {
    const bool is_missed = error.outcome == RayOutcome::missed, is_false = error.outcome == RayOutcome::false_surface;
    if (aovs.missed) layers.missed.push_back(is_missed ? 1 : is_false ? 2 : 0);
    if (!aovs.error) continue;
    if (is_missed || is_false) {
      layers.error.insert(layers.error.end(), {kNever, kNever});
    } else {
      layers.error.insert(layers.error.end(), {static_cast<float>(error.pixels), static_cast<float>(error.units)});
    }
  }
}

}  // namespace

bool measure_layers(const scene::Database& database, const TracerOptions& options, const Tracer& tracer,
                    const Aovs& aovs, int threads, const std::atomic<bool>* stop, const TellProgress& tell,
                    Image& image) {
  if (!aovs.any_measured()) return true;
  const std::vector<Ray> rays =
      rays_of(database.camera.value_or(scene::default_camera(image.full_width, image.full_height)), image);
  std::vector<RayMeasure> found(rays.size()), truth;
  const bool wants_errors = aovs.error || aovs.missed;
  const double first_share = wants_errors ? 0.5 : 1;
  const auto told = [&](double begin, double share) -> TellProgress {
    if (!tell) return {};
    return [&tell, begin, share](double done) { tell(begin + share * done); };
  };
  with_threads(threads > 0 ? threads : default_thread_count(), [&] {
    measure_each(tracer, rays, found, stop, told(0, first_share));
    if (!wants_errors) return;
    TracerOptions exact = options;
    exact.solver = SolverName::exact;
    const Tracer reference(database, exact);
    truth.resize(rays.size());
    measure_each(reference, rays, truth, stop, told(first_share, 1 - first_share));
  });
  set_costs(found, aovs, image.layers);
  if (wants_errors) {
    std::vector<RayError> errors;
    errors.reserve(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      errors.push_back(error_of(rays[i], found[i], truth[i], options.pixel_angle));
    }
    set_errors(errors, aovs, image.layers);
  }
  return stop == nullptr || !stop->load();
}

}  // namespace isl::render
