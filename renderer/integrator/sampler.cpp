#include "renderer/integrator/sampler.h"

#include <algorithm>

namespace isl::render {
namespace {

/// As many samples are added to the film in the time that memory takes.
constexpr std::size_t kSamplesAhead = 32;

/// Stores the surfaces that the centre samples of pixels see in the film's layers.
class LayerKeeper final : public SurfaceObserver {
 public:
  LayerKeeper(std::span<const CameraSample> samples, const WorkingSpace& space, Film& film)
      : samples_(samples), space_(space), film_(film) {}

  void see(std::uint32_t ray, const Hit& hit, const SurfacePoint& surface, const ShadingPoint& point) override {
    const CameraSample& sample = samples_[ray];
    if (sample.is_centre) film_.set_surface(sample.pixel, {&hit, &surface, space_.to_linear(plain_colour(point))});
  }

 private:
  std::span<const CameraSample> samples_;
  const WorkingSpace& space_;
  Film& film_;
};

}  // namespace

bool Sampler::bend(std::span<const CameraSample> samples, std::span<Ray> rays) const {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (rays[i].direction == Vec3(0)) continue;
    if (bumps_->bend(camera_.bent_at(samples[i].x, samples[i].y), rays[i].direction)) continue;
    quick_.refuse("the camera", camera_origin_);
    return false;
  }
  return true;
}

void Sampler::set_blurred(std::span<const CameraSample> samples, Workspace& workspace) const {
  std::vector<UnitPoint>& on_lens = workspace.on_lens;
  on_lens.resize(samples.size());
  set_centred_points(kLensSquare, workspace.paths.pixel_samples, on_lens);
  lens_->set_on_lens(on_lens);
  std::vector<Ray>& rays = workspace.paths.camera_rays();
  RecurringAngles angles;
  for (std::size_t i = 0; i < samples.size(); ++i)
    camera_.set_through(samples[i].x, samples[i].y, lens_->offset(on_lens[i]), angles, rays[i]);
}

bool Sampler::trace(std::span<const CameraSample> samples, std::span<const PixelSample> places, Workspace& workspace,
                    SampleObserver* observer) const {
  workspace.paths.pixel_samples.assign(places.begin(), places.end());
  LayerKeeper keeper(samples, working_space_, film_);
  if (!trace_paths(samples, workspace, film_.keeps_surfaces() ? &keeper : nullptr)) return false;
  add(samples, workspace.paths, observer);
  return true;
}

bool Sampler::set_rays(std::span<const CameraSample> samples, Workspace& workspace) const {
  std::vector<Ray>& rays = workspace.paths.camera_rays();
  rays.resize(samples.size());
  if (lens_) {
    set_blurred(samples, workspace);
  } else {
    RecurringAngles angles;
    for (std::size_t i = 0; i < samples.size(); ++i) camera_.set_through(samples[i].x, samples[i].y, angles, rays[i]);
  }
  if (camera_.is_spent()) {
    quick_.refuse("the camera", camera_origin_);
    return false;
  }
  return !bumps_ || bend(samples, rays);
}

bool Sampler::trace_paths(std::span<const CameraSample> samples, Workspace& workspace,
                          SurfaceObserver* observer) const {
  PathMemory& paths = workspace.paths;
  const PathCounts counts = paths.counts;
  const TraceCounters counters = paths.counters;
  if (!set_rays(samples, workspace) || !quick_.trace(paths, observer)) return false;
  if (paths.counters.spent_rays == counters.spent_rays) return true;
  const Integrator* const whole =
      whole_.integrator([this](const Integrator& integrator) { return is_hard(integrator); });
  if (whole == nullptr) return true;
  paths.counts = counts;
  paths.counters = counters;
  return set_rays(samples, workspace) && whole->trace(paths, observer);
}

bool Sampler::is_hard(const Integrator& whole) const {
  constexpr int kEvery = 31, kAllowed = 1000;
  constexpr std::size_t kTogether = 64;  // so that a hard picture is told after few rays
  std::vector<CameraSample> lattice;
  for (int y = kEvery / 2; y < picture_.y1; y += kEvery) {
    for (int x = kEvery / 2; x < picture_.x1; x += kEvery) lattice.push_back({x + 0.5, y + 0.5});
  }
  const auto workspace = std::make_unique<Workspace>();
  const std::uint64_t& in_vain = workspace->paths.counters.vain_rays;
  for (std::size_t first = 0; first < lattice.size() && in_vain * kAllowed <= lattice.size(); first += kTogether) {
    const std::span<const CameraSample> part =
        std::span(lattice).subspan(first, std::min(kTogether, lattice.size() - first));
    if (whole.is_soft() || lens_) workspace->paths.pixel_samples.assign(part.size(), {0, 0, 1});
    if (!set_rays(part, *workspace) || !whole.trace(workspace->paths, nullptr)) return true;
  }
  return in_vain * kAllowed > lattice.size();
}

std::vector<std::uint8_t> Sampler::lose_samples(std::span<const CameraSample> samples, const PathMemory& paths,
                                                std::span<Rgb> colours, std::span<double> alphas) const {
  const std::vector<Hit>& hits = paths.levels.front().batch.hits;
  std::vector<std::uint8_t> lost(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (is_finite(colours[i], alphas[i])) continue;
    film_.lose_sample(samples[i].pixel, hits[i].is_miss() ? OriginId{} : quick_tracer_.origin_of(hits[i]));
    colours[i] = Rgb(0);
    alphas[i] = 0;
    lost[i] = 1;
  }
  return lost;
}

void Sampler::add(std::span<const CameraSample> samples, PathMemory& paths, SampleObserver* observer) const {
  const std::span<Rgb> colours = std::span(paths.colours).first(samples.size());
  const std::span<double> alphas = std::span(paths.alphas).first(samples.size());
  if (film_.is_linear()) working_space_.make_linear(colours);
  const std::span<const Ray> rays = paths.camera_rays();
  auto worst = Certainty::certified;
  double size = 0;  // of all samples: not finite if that of one is not
  for (std::size_t i = 0; i < samples.size(); ++i) {
    lower(worst, paths.certainties[i]);
    if (rays[i].direction == Vec3(0)) {  // the camera shows nothing there
      colours[i] = Rgb(0);
      alphas[i] = blank_alpha_;
    }
    size += size_of(colours[i], alphas[i]);
  }
  std::vector<std::uint8_t> lost;
  if (!(size < kLostSize)) lost = lose_samples(samples, paths, colours, alphas);
  if (worst != Certainty::certified) {
    for (std::size_t i = 0; i < samples.size(); ++i) film_.lower_certainty(samples[i].pixel, paths.certainties[i]);
  }
  for (std::size_t first = 0, last = 0; first < samples.size(); first = last) {
    const std::uint32_t pixel = samples[first].pixel;
    do {
      if (last + kSamplesAhead < samples.size()) film_.expect_sample(samples[last + kSamplesAhead].pixel);
    } while (++last < samples.size() && samples[last].pixel == pixel);
    const std::size_t count = last - first;
    film_.add_samples(pixel, colours.subspan(first, count), alphas.subspan(first, count));
    if (!observer) continue;
    if (!lost.empty()) {
      // The estimate of noise needs all samples. A lost one is as the others are.
      const auto [red, green, blue, alpha] = film_.raw_mean(pixel);
      for (std::size_t i = first; i < last; ++i) {
        if (lost[i] == 0) continue;
        colours[i] = {red, green, blue};
        alphas[i] = alpha;
      }
    }
    observer->add(samples[last - 1], colours.subspan(first, count), alphas.subspan(first, count));
  }
}

}  // namespace isl::render
