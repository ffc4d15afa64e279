// Rendering makes passes over the tiles. Without a limit of noise there are two: the first takes one centre sample in
// every pixel (all samples, if their number is fixed); the second takes the remaining samples in the pixels that differ
// from a neighbour. With a limit, each pass doubles the samples of the pixels that have more noise. Each tile is one
// task, whose result depends only on its tile and the passes before: the picture does not depend on the number of
// threads or their order.
#include "renderer/render.h"

#include "base/check.h"
#include "base/parallel.h"
#include "renderer/film/adaptive.h"
#include "renderer/film/progress.h"
#include "renderer/film/sample_pattern.h"
#include "renderer/integrator/noise_observer.h"
#include "renderer/scene/default_camera.h"

#include <algorithm>
#include <chrono>

namespace isl::render {
namespace {

/// Share of the progress bar for the first of two passes. It is a guess, because the amount of work in the second is
/// not known beforehand.
constexpr double kFirstPassShare = 0.4;

PixelRect clipped(const PixelRect& rect, const RenderOptions& options) {
  PixelRect result{std::clamp(rect.x0, 0, options.width), std::clamp(rect.y0, 0, options.height),
                   std::clamp(rect.x1, 0, options.width), std::clamp(rect.y1, 0, options.height)};
  if (result.empty()) result = {};
  return result;
}

/// The pixels on which those of `window` depend: the adaptive rule compares a pixel with its neighbours, and the rule
/// of noise does so in every pass.
PixelRect with_neighbours(const PixelRect& window, const RenderOptions& options) {
  if (window.empty() || options.samples) return window;
  const int border = options.max_noise ? kMostNoisePasses : 1;
  return clipped({window.x0 - border, window.y0 - border, window.x1 + border, window.y1 + border}, options);
}

/// The part of the picture to render.
PixelRect window_of(const RenderOptions& options) {
  return clipped(options.crop.value_or(PixelRect{0, 0, options.width, options.height}), options);
}

PixelRect film_rect(const RenderOptions& options) { return with_neighbours(window_of(options), options); }

/// The images that the scene's textures refer to. Those of functions cannot be told apart, so that they are all needed.
std::vector<bool> needed_images(const scene::Database& database) {
  std::vector<bool> is_needed(database.images.size(), !database.functions.empty());
  const SceneUse use(database);
  for (const Use<scene::Image>& image : use.images())
    is_needed[static_cast<std::size_t>(image.record - database.images.data())] = true;
  return is_needed;
}

class Rendering {
 public:
  Rendering(const scene::Database& database, const Tracer& tracer, const RenderOptions& options, const Plan& plan,
            const ImageTable* images)
      : options_(options),
        window_(window_of(options)),
        is_soft_(plan.is_soft() || options.max_noise),
        first_samples_(static_cast<std::size_t>(first_samples(plan))),
        film_(film_rect(options), options.aovs,
              is_soft_ ? std::optional<WorkingSpace>(database.settings) : std::nullopt),
        pattern_(sample_pattern(options.samples.value_or(kAdaptiveSamples))),
        sampler_(database, tracer, plan,
                 CameraRays(database.camera.value_or(scene::default_camera(options.width, options.height)),
                            options.width, options.height, CameraFunctions::of(database, options.run, images)),
                 {0, 0, options.width, options.height}, options.alpha, film_, options.run, images),
        progress_(options.progress) {}

  void run() {
    if (options_.samples) {
      progress_.begin_stage(1, tiles_of(film_.rect(), options_.tile_order).size());
      const Range all{0, pattern_.size()};
      trace_tiles(film_.rect(), [all](const Pixel&) { return all; });
      return;
    }
    if (options_.max_noise) return run_until_quiet(*options_.max_noise);
    progress_.begin_stage(kFirstPassShare, tiles_of(film_.rect(), options_.tile_order).size());
    trace_tiles(film_.rect(), [](const Pixel&) { return Range{0, 1}; });
    if (stopped()) return;
    DisplayedPass displayed(film_.rect());
    parallel_for(static_cast<std::size_t>(film_.rect().height()), [&](std::size_t row) {
      if (!stopped()) displayed.fill_row(film_, film_.rect().y0 + static_cast<int>(row));
    });
    progress_.begin_stage(1, tiles_of(window_, options_.tile_order).size());
    trace_tiles(window_, [&](const Pixel& pixel) {
      return displayed.is_rough(pixel.x, pixel.y, options_.aa) ? Range{1, pattern_.size()} : Range{};
    });
  }

  /// Reports that rendering is finished, unless it was stopped.
  void finish() {
    if (!skipped_) progress_.finish();
  }

  [[nodiscard]] RenderResult result() {
    RenderResult result;
    result.image = film_.develop(window_, options_.width, options_.height, options_.alpha);
    workspaces_.for_each([&](const Workspace& workspace) {
      result.statistics.paths += workspace.paths.counts;
      result.statistics.counters += workspace.paths.counters;
    });
    if (film_.rect().area() > 0) {
      result.statistics.samples_per_pixel =
          static_cast<double>(result.statistics.paths.camera) / static_cast<double>(film_.rect().area());
    }
    result.statistics.undecided_pixels = film_.count(window_, Certainty::undecided);
    result.statistics.refuted_pixels = film_.count(window_, Certainty::refuted);
    result.statistics.lost = film_.lost(window_);
    result.statistics.noisy_pixels = noisy_pixels_;
    result.complete = !skipped_;
    result.share = skipped_ ? progress_.share() : 1;
    result.refusal = sampler_.refusal();
    return result;
  }

 private:
  [[nodiscard]] bool stopped() {
    if (is_set(options_.run.stop)) skipped_ = true;
    return skipped_;
  }

  /// Doubles the samples of pixels until they have no more noise than this.
  void run_until_quiet(double max_noise) {
    PixelNoise noise(film_);
    noise_ = &noise;
    double done = 0;
    for (int pass = 0; pass < kMostNoisePasses && noise.choose(max_noise, kMostSamples) != 0 && !stopped(); ++pass) {
      // Half of what is left: nobody knows how many pixels need more.
      done = (1 + done) / 2;
      progress_.begin_stage(done, tiles_of(film_.rect(), options_.tile_order).size());
      trace_tiles(film_.rect(), [&](const Pixel& pixel) {
        const std::size_t at = film_.rect().index(pixel.x, pixel.y);
        const std::size_t count = film_.samples(at);
        if (!noise.is_chosen(at)) return Range{};
        return count == 0 ? Range{0, first_samples_} : Range{count, 2 * count};
      });
    }
    noise.choose(max_noise, kMostSamples);
    noisy_pixels_ = noise.count_above(window_, max_noise);
    noise_ = nullptr;
  }

  /// Numbers of samples, the last not included.
  struct Range {
    std::size_t first = 0, last = 0;
  };

  /// Traces for every pixel of `rect` the samples that wanted(pixel) returns.
  template <class Wanted>
  void trace_tiles(const PixelRect& rect, const Wanted& wanted) {
    const std::vector<PixelRect> tiles = tiles_of(rect, options_.tile_order);
    parallel_for(tiles.size(), [&](std::size_t i) {
      if (stopped()) return;
      trace_tile(tiles[i], wanted);
      if (!skipped_) progress_.step();
    });
  }

  template <class Wanted>
  void trace_tile(const PixelRect& tile, const Wanted& wanted) {
    Workspace& workspace = workspaces_.local();
    pixels_of(tile, workspace.pixels);
    workspace.places.clear();
    // Copies, because the compiler does not know that nothing that is written here changes them.
    const PixelRect rect = film_.rect();
    const SampleOffset* const offsets = pattern_.data();
    const bool is_soft = is_soft_, is_spread = noise_ != nullptr;
    CameraSample* const samples = workspace.samples.data();
    std::size_t count = 0;
    for (const Pixel& pixel : workspace.pixels) {
      const Range range = wanted(pixel);
      if (range.first == range.last) continue;
      const auto at = static_cast<std::uint32_t>(rect.index(pixel.x, pixel.y));
      const std::uint32_t seed = is_soft ? pixel_seed(pixel.x, pixel.y) : 0;
      for (std::size_t i = range.first; i < range.last; ++i) {
        const SampleOffset offset = is_spread ? SampleOffset{0, 0} : offsets[i];
        samples[count] = {pixel.x + 0.5 + offset.x, pixel.y + 0.5 + offset.y, at, i == 0, i + 1 == range.last};
        if (is_soft) workspace.places.push_back(among(seed, i));
        if (++count < kBatchSize) continue;
        flush(workspace, count);
        count = 0;
      }
    }
    if (count > 0) flush(workspace, count);
  }

  /// A sample takes one point of every integral if the pixel's noise tells when there are enough. Else the pixel takes
  /// as many as the scene says: the one sample of a first pass takes all of them, and so do the samples of a second
  /// together, which begin behind those of the first.
  [[nodiscard]] PixelSample among(std::uint32_t seed, std::size_t i) const {
    const auto index = static_cast<std::uint32_t>(i);
    if (noise_) return {seed, index, static_cast<std::uint32_t>(kMostSamples)};
    if (!options_.samples && i == 0) return {seed, 0, 1};
    constexpr std::uint32_t kBehindFirstPass = 0x10000;
    return {seed, options_.samples ? index : kBehindFirstPass + index, static_cast<std::uint32_t>(pattern_.size())};
  }

  /// Traces the samples that have been made.
  void flush(Workspace& workspace, std::size_t count) {
    const std::span<CameraSample> samples = std::span(workspace.samples).first(count);
    std::optional<NoiseObserver> observer;
    if (noise_) {
      observer.emplace(*noise_, workspace.noise);
      spread_over_pixels(samples, workspace);
    }
    if (!sampler_.trace(samples, workspace.places, workspace, observer ? &*observer : nullptr)) skipped_ = true;
    workspace.places.clear();
  }

  /// Moves samples from the middles of their pixels to points of their sequences.
  void spread_over_pixels(std::span<CameraSample> samples, Workspace& workspace) const {
    workspace.in_pixel.resize(samples.size());
    set_centred_points(pixel_square(sampler_.has_lens()), workspace.places, workspace.in_pixel);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i].x += workspace.in_pixel[i].u;
      samples[i].y += workspace.in_pixel[i].v;
    }
  }

  const RenderOptions& options_;
  PixelRect window_;
  bool is_soft_;  ///< samples are spread over more than the pixel, or stop by their noise
  std::size_t first_samples_;
  Film film_;
  std::vector<SampleOffset> pattern_;
  Sampler sampler_;
  Progress progress_;
  PerThread<Workspace> workspaces_;
  PixelNoise* noise_ = nullptr;  ///< if pixels stop by their noise
  std::uint64_t noisy_pixels_ = 0;
  std::atomic<bool> skipped_ = false;
};

}  // namespace

int first_samples(const Plan& plan) {
  const bool looks_around = std::ranges::any_of(
      plan.called_for, [](const PlannedEffect& planned) { return planned.effect->stages.around != nullptr; });
  return looks_around ? 8 : 4;
}

RenderResult render(const scene::Database& database, const Tracer& tracer, const RenderOptions& options) {
  ISL_CHECK(options.width >= 1 && options.height >= 1, "picture of {}x{}", options.width, options.height);
  ISL_CHECK(options.threads >= 0, "{} threads", options.threads);
  Plan plan = plan_of(database, {.quality = options.quality, .without = options.without});
  ImageTable images;
  if (plan.has("images")) {
    ImageLibrary own(options.run);
    ImageSource& source = options.images ? *options.images : own;
    if (auto refusal = source.prepare(database, needed_images(database), images)) {
      RenderResult refused;
      refused.refusal = std::move(refusal);
      return refused;
    }
  }
  Charge noise_memory(options.run.budget);
  if (options.max_noise && !noise_memory.grow(PixelNoise::bytes_for(film_rect(options).area()))) {
    RenderResult refused;
    refused.refusal = scene::Refusal{
        .message = "a picture of this size that stops by its noise takes more memory than the limit leaves",
        .hint = "`--max-memory` raises the limit, and `--samples` takes less"};
    return refused;
  }
  Rendering rendering(database, tracer, options, plan, &images);
  const int threads = options.threads > 0 ? options.threads : default_thread_count();
  const auto begin = std::chrono::steady_clock::now();
  with_threads(threads, [&] { rendering.run(); });
  rendering.finish();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  RenderResult result;
  with_threads(threads, [&] { result = rendering.result(); });
  result.statistics.seconds = elapsed.count();
  result.statistics.threads = threads;
  result.statistics.plan = std::move(plan);
  return result;
}

}  // namespace isl::render
