// Renders a database with its tracer into a picture in memory. This is the renderer's interface: cli calls it and
// writes the picture with image/image_file.
#pragma once

#include "base/run_limits.h"
#include "renderer/effects/plan.h"
#include "renderer/film/tiles.h"
#include "renderer/image/image.h"
#include "renderer/image/image_library.h"
#include "renderer/integrator/sampler.h"
#include "renderer/trace/tracer.h"

#include <functional>
#include <optional>

namespace isl::render {

struct RenderOptions {
  int width = 800;  ///< width of the whole picture, at least 1
  int height = 600;
  int threads = 0;  ///< greatest number of threads; 0: one per core
  /// The fixed number of rays per pixel (at least 1). Nullopt: as many as `max_noise` asks for; without that, one, and
  /// kAdaptiveSamples where pixels differ.
  std::optional<int> samples;
  /// The noise of a pixel below which it gets no more samples (above 0): the RMS error over its channels of display
  /// code (0 to 1), as its samples tell. Pixels get first_samples() at least and kMostSamples at most.
  std::optional<double> max_noise;
  /// The greatest difference of neighbouring pixels, in any channel of display code (0 to 1), above which both get all
  /// samples.
  double aa = 0.1;
  int quality = 9;                   ///< PlanOptions::quality
  std::vector<std::string> without;  ///< PlanOptions::without
  bool alpha = false;                ///< the background is transparent
  std::optional<PixelRect>
      crop;  ///< the rectangle to render, clipped to the picture; its pixels are the same as in the whole picture
  Aovs aovs;
  TileOrder tile_order = TileOrder::rows;
  /// Called from time to time with the share that is done (0 to 1, never falling), on a rendering thread, one call at a
  /// time.
  std::function<void(double)> progress;
  ImageSource* images = nullptr;  ///< where images that are decoded already may be found; may be null
  RunLimits run;                  ///< once its flag is set, rendering ends early with the batches that are finished
};

/// Total number of rays of a pixel that differs from a neighbour.
inline constexpr int kAdaptiveSamples = 16;

/// Limits of the samples of a pixel that stops by its noise; powers of two. Directions all around need more first
/// samples than the points of a light or lens: what few of them miss is often a small bright part of the sky.
[[nodiscard]] int first_samples(const Plan& plan);
inline constexpr int kMostSamples = 4096;

struct RenderStatistics {
  PathCounts paths;
  TraceCounters counters;
  double seconds = 0;  ///< from the first ray to the last
  int threads = 1;     ///< greatest number of threads at work
  double samples_per_pixel = 0;
  std::uint64_t undecided_pixels = 0, refuted_pixels = 0;  ///< Certainty
  LostSamples lost;                                        ///< those left out, as no finite numbers
  std::uint64_t noisy_pixels = 0;                          ///< with kMostSamples and more noise than was asked for
  Plan plan;
};

struct RenderResult {
  Image image;
  RenderStatistics statistics;
  bool complete = true;  ///< false if rendering was stopped: pixels without samples are transparent black
  double share = 1;      ///< of the work that was done, as the progress bar counts it
  /// The reason why the scene cannot be rendered within the limits of the run. The picture is then meaningless.
  std::optional<scene::Refusal> refusal;
};

/// Equal databases, tracer options and options (except threads, tile_order, progress) give the same image, bit for bit.
/// Without a camera in the scene POV-Ray's default one is used.
[[nodiscard]] RenderResult render(const scene::Database& database, const Tracer& tracer, const RenderOptions& options);

}  // namespace isl::render
