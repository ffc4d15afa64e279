// Rays in waves: camera rays of a batch of samples → hits → lit surface points → shadow queue → what is unoccluded is
// added → the film. One wave is one thread's work from beginning to end; the workspace keeps its memory from wave to
// wave.
#pragma once

#include "renderer/effects/plan.h"
#include "renderer/effects/shadows.h"
#include "renderer/image/camera.h"
#include "renderer/image/film.h"
#include "renderer/image/tiles.h"
#include "renderer/image/transfer.h"
#include "renderer/shading/point_textures.h"

#include <span>
#include <vector>

namespace isl::render {

/// One camera ray to trace: a raster position in pixels from the picture's top left corner, and where the result goes.
struct CameraSample {
  double x = 0, y = 0;
  std::uint32_t pixel = 0;  ///< of the film
  bool is_centre = false;   ///< the pixel's first sample, which fills the layers
};

struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t shadow = 0;

  RayCounts& operator+=(const RayCounts& other) {
    camera += other.camera;
    shadow += other.shadow;
    return *this;
  }
};

/// Memory of one thread, and its counts. `pixels` and `samples` are for whoever makes the waves.
struct Workspace {
  std::vector<Pixel> pixels;
  std::vector<CameraSample> samples;
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  std::vector<Rgb> colours;  ///< working space
  ShadowQueue shadows;
  SurfacePoint point;
  std::vector<LitTexture> textures;  ///< of `point`
  RayCounts counts;
  TraceCounters counters;
};

/// What all waves of a rendering share; immutable but for the film. Everything referred to must outlive it.
class WaveRenderer {
 public:
  WaveRenderer(const scene::Database& database, const Tracer& tracer, const Plan& plan, const CameraRays& camera,
               bool transparent_background, Film& film);

  /// Traces the samples and adds them to the film in their order. A pixel must not be in two threads' waves at a time.
  void trace(std::span<const CameraSample> samples, Workspace& workspace) const;

 private:
  void shade_hit(std::uint32_t sample, const CameraSample& where, Workspace& workspace) const;
  void trace_shadows(Workspace& workspace) const;

  const scene::Database& database_;
  const Tracer& tracer_;
  const Plan& plan_;
  CameraRays camera_;
  PointTextures textures_;
  WorkingSpace working_space_;
  Rgb background_{0};
  double background_alpha_ = 1;
  bool keeps_layers_ = false;
  Film& film_;
};

}  // namespace isl::render
