// Rendering makes two passes over the tiles. The first takes one centre sample in every pixel (all samples, if their
// number is fixed); the second takes the remaining samples in the pixels that differ from a neighbour. Each tile is one
// task, whose result depends only on its tile and the first pass: the picture does not depend on the number of threads
// or their order.
#include "renderer/render.h"

#include "base/check.h"
#include "base/parallel.h"
#include "renderer/film/adaptive.h"
#include "renderer/film/progress.h"
#include "renderer/film/sample_pattern.h"
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

/// The pixels that the adaptive rule compares for `window`: the window and one pixel more on each side.
PixelRect with_neighbours(const PixelRect& window, const RenderOptions& options) {
  if (window.empty()) return window;
  return clipped({window.x0 - 1, window.y0 - 1, window.x1 + 1, window.y1 + 1}, options);
}

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
        window_(clipped(options.crop.value_or(PixelRect{0, 0, options.width, options.height}), options)),
        film_(options.samples ? window_ : with_neighbours(window_, options), options.aovs),
        pattern_(sample_pattern(options.samples.value_or(kAdaptiveSamples))),
        sampler_(database, tracer, plan,
                 CameraRays(database.camera.value_or(scene::default_camera(options.width, options.height)),
                            options.width, options.height),
                 options.alpha, film_, options.run, images),
        progress_(options.progress) {}

  void run() {
    if (options_.samples) {
      progress_.begin_stage(1, tiles_of(film_.rect(), options_.tile_order).size());
      trace_tiles(film_.rect(), 0, pattern_.size(), [](const Pixel&) { return true; });
      return;
    }
    progress_.begin_stage(kFirstPassShare, tiles_of(film_.rect(), options_.tile_order).size());
    trace_tiles(film_.rect(), 0, 1, [](const Pixel&) { return true; });
    if (stopped()) return;
    DisplayedPass displayed(film_.rect());
    parallel_for(static_cast<std::size_t>(film_.rect().height()), [&](std::size_t row) {
      if (!stopped()) displayed.fill_row(film_, film_.rect().y0 + static_cast<int>(row));
    });
    progress_.begin_stage(1, tiles_of(window_, options_.tile_order).size());
    trace_tiles(window_, 1, pattern_.size(),
                [&](const Pixel& pixel) { return displayed.is_rough(pixel.x, pixel.y, options_.aa); });
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

  /// Traces the samples from `first` up to, not including, `last` of the sampling pattern for every pixel of `rect` for
  /// which `wanted` is true.
  template <class Wanted>
  void trace_tiles(const PixelRect& rect, std::size_t first, std::size_t last, const Wanted& wanted) {
    const std::vector<PixelRect> tiles = tiles_of(rect, options_.tile_order);
    parallel_for(tiles.size(), [&](std::size_t i) {
      if (stopped()) return;
      trace_tile(tiles[i], first, last, wanted);
      if (!skipped_) progress_.step();
    });
  }

  template <class Wanted>
  void trace_tile(const PixelRect& tile, std::size_t first, std::size_t last, const Wanted& wanted) {
    Workspace& workspace = workspaces_.local();
    pixels_of(tile, workspace.pixels);
    workspace.samples.clear();
    for (const Pixel& pixel : workspace.pixels) {
      if (!wanted(pixel)) continue;
      for (std::size_t i = first; i < last; ++i) {
        workspace.samples.push_back({pixel.x + 0.5 + pattern_[i].x, pixel.y + 0.5 + pattern_[i].y,
                                     static_cast<std::uint32_t>(film_.rect().index(pixel.x, pixel.y)), i == 0});
        if (workspace.samples.size() == kBatchSize) flush(workspace);
      }
    }
    flush(workspace);
  }

  void flush(Workspace& workspace) {
    if (workspace.samples.empty()) return;
    if (!sampler_.trace(workspace.samples, workspace)) skipped_ = true;
    workspace.samples.clear();
  }

  const RenderOptions& options_;
  PixelRect window_;
  Film film_;
  std::vector<SampleOffset> pattern_;
  Sampler sampler_;
  Progress progress_;
  PerThread<Workspace> workspaces_;
  std::atomic<bool> skipped_ = false;
};

}  // namespace

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
