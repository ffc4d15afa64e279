#include "renderer/image/wave.h"

namespace isl::render {
namespace {

/// Shadow rays after which the queue is traced before the wave's last sample, so that a scene of thousands of lights
/// needs no more memory. Every sample still gets its light in the order of the lights.
constexpr std::size_t kLongestQueue = 1 << 16;

}  // namespace

WaveRenderer::WaveRenderer(const scene::Database& database, const Tracer& tracer, const Plan& plan,
                           const CameraRays& camera, bool transparent_background, Film& film)
    : database_(database),
      tracer_(tracer),
      plan_(plan),
      camera_(camera),
      textures_(database),
      working_space_(database.settings),
      keeps_layers_(film.aovs().any_of_surface()),
      film_(film) {
  const scene::Colour& background = database.settings.background;
  if (transparent_background) {
    background_alpha_ = 0;
  } else {
    background_ = rgb(background) * (1 - background.transmit);
  }
}

void WaveRenderer::shade_hit(std::uint32_t sample, const CameraSample& where, Workspace& workspace) const {
  const Ray& ray = workspace.rays[sample];
  const Hit& hit = workspace.hits[sample];
  SurfacePoint& surface = workspace.point;
  tracer_.surface_at(ray, hit, surface, workspace.counters);
  textures_.at(surface, workspace.textures);
  const ShadingPoint point{surface.position, turned_to_viewer(surface.normal, ray.direction), ray.direction,
                           workspace.textures};
  if (keeps_layers_ && where.is_centre) {
    film_.set_surface(where.pixel, {&hit, &surface, working_space_.to_linear(plain_colour(point))});
  }
  Rgb& colour = workspace.colours[sample];
  if (plan_.plain_colours) {
    colour = plain_colour(point);
    return;
  }
  colour = ambient_colour(point);
  if (!plan_.lighting) return;
  for (const scene::Light& light : database_.lights) {
    const LightArrival arrival = light_arrival(point, light, plan_.highlights);
    if (arrival.is_dark()) continue;
    if (plan_.shadows && !light.shadowless) {
      workspace.shadows.push(sample, arrival, point.position, hit.start(), ray.path_length + hit.t);
    } else {
      colour += arrival.colour;
    }
  }
}

void WaveRenderer::trace_shadows(Workspace& workspace) const {
  workspace.shadows.resolve(tracer_, workspace.colours, workspace.counters);
  workspace.counts.shadow += workspace.shadows.size();
  workspace.shadows.clear();
}

void WaveRenderer::trace(std::span<const CameraSample> samples, Workspace& workspace) const {
  workspace.rays.clear();
  for (const CameraSample& sample : samples) workspace.rays.push_back(camera_.through(sample.x, sample.y));
  workspace.hits.assign(samples.size(), Hit{});
  workspace.colours.assign(samples.size(), background_);
  workspace.shadows.clear();
  tracer_.first_hits(workspace.rays, workspace.hits, workspace.counters);
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    if (!workspace.hits[i].is_miss()) shade_hit(i, samples[i], workspace);
    if (workspace.shadows.size() >= kLongestQueue) trace_shadows(workspace);
  }
  trace_shadows(workspace);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double alpha = workspace.hits[i].is_miss() ? background_alpha_ : 1;
    film_.add_sample(samples[i].pixel, working_space_.to_linear(workspace.colours[i]), alpha);
  }
  workspace.counts.camera += samples.size();
}

}  // namespace isl::render
