// A database and its tracer → a picture in memory. The renderer's front door: cli calls this, then image/image_file.
#pragma once

#include "renderer/effects/plan.h"
#include "renderer/film/tiles.h"
#include "renderer/image/image.h"
#include "renderer/integrator/sampler.h"
#include "renderer/trace/tracer.h"

#include <atomic>
#include <functional>
#include <optional>

namespace isl::render {

struct RenderOptions {
  int width = 800;  ///< of the whole picture, at least 1
  int height = 600;
  int threads = 0;  ///< at most this many; 0: one a core
  /// Exactly so many rays in every pixel (at least 1); none: one, and up to kAdaptiveSamples where pixels differ.
  std::optional<int> samples;
  /// How much neighbouring pixels may differ, in any channel of display code (0 to 1), before both are sampled fully.
  double aa = 0.1;
  int quality = 9;     ///< PlanOptions::quality
  std::vector<std::string> without;  ///< PlanOptions::without
  bool alpha = false;  ///< what the background would show is transparent
  std::optional<PixelRect>
      crop;  ///< only these pixels; clipped to the picture. They are the same as in the whole picture.
  Aovs aovs;
  TileOrder tile_order = TileOrder::rows;
  /// Told the share done (0 to 1, never falling) every now and then: from a rendering thread, one call at a time.
  std::function<void(double)> progress;
  const std::atomic<bool>* stop = nullptr;  ///< once true, rendering ends early with what is done
};

/// Rays that a pixel gets in all where it differs from a neighbour.
inline constexpr int kAdaptiveSamples = 16;

struct RenderStatistics {
  PathCounts paths;
  TraceCounters counters;
  double seconds = 0;  ///< from the first ray to the last
  int threads = 1;     ///< that could work
  double samples_per_pixel = 0;
  Plan plan;
};

struct RenderResult {
  Image image;
  RenderStatistics statistics;
  bool complete = true;  ///< false when stopped: pixels of tiles not begun are transparent black
};

/// The same database, tracer options and options (but threads, tile_order, progress) give the same image, bit for bit.
/// Without a camera in the scene POV-Ray's default one is used.
[[nodiscard]] RenderResult render(const scene::Database& database, const Tracer& tracer, const RenderOptions& options);

}  // namespace isl::render
