// Turns samples of pixels into camera rays and adds what they see to the film: the integrator's work on one batch, for
// one thread.
#pragma once

#include "renderer/film/block_noise.h"
#include "renderer/film/camera.h"
#include "renderer/film/camera_bumps.h"
#include "renderer/film/film.h"
#include "renderer/film/lens.h"
#include "renderer/film/tiles.h"
#include "renderer/image/transfer.h"
#include "renderer/integrator/integrator.h"
#include "renderer/integrator/whole_bound.h"
#include "renderer/paths/soft_points.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace isl::render {

/// One camera ray to trace: a raster position in pixels from the picture's top left corner, and the pixel that gets the
/// result.
struct CameraSample {
  double x = 0, y = 0;
  std::uint32_t pixel = 0;  ///< its index in the film
  bool is_centre = false;   ///< the pixel's first sample, which fills the layers
  bool is_last = false;     ///< of the pixel's in its pass
};

/// Is told of the samples of one pixel after the other as they are added to the film.
class SampleObserver {
 public:
  virtual ~SampleObserver() = default;
  /// Some of a pixel's samples in their order. `last` is the last of them.
  virtual void add(const CameraSample& last, std::span<const Rgb> colours, std::span<const double> alphas) = 0;
};

/// Memory of one thread, and its counts. `pixels`, `samples`, `places` and `in_pixel` serve the caller that makes the
/// batches.
struct Workspace {
  std::vector<Pixel> pixels;
  std::array<CameraSample, kBatchSize> samples;
  std::vector<PixelSample> places;  ///< of the samples among those of their pixels, if the picture has something soft
  std::vector<UnitPoint> in_pixel, on_lens;  ///< the points through which samples look
  BlockNoise noise;                          ///< of the present pixel
  PathMemory paths;
};

/// Immutable except for the film. Everything that it refers to must outlive it.
class Sampler {
 public:
  /// `picture` is the whole picture, of which the film may be a part.
  Sampler(const scene::Database& database, const Tracer& tracer, const Plan& plan, const CameraRays& camera,
          const PixelRect& picture, bool transparent_background, Film& film, const RunLimits& run = {},
          const ImageTable* images = nullptr)
      : quick_tracer_(tracer.with_ray_steps(tenth_of(tracer.ray_steps()))),
        quick_(database, quick_tracer_, plan, transparent_background, run, images),
        whole_([&, transparent_background, run, images] {
          return std::make_unique<Integrator>(database, tracer, plan, transparent_background, run, images);
        }),
        camera_(camera),
        picture_(picture),
        camera_origin_(database.camera.value_or(scene::Camera{}).origin),
        working_space_(database.settings),
        blank_alpha_(transparent_background ? 0 : 1),
        film_(film) {
    if (plan.has("camera_normal")) bumps_.emplace(database, run, images);
    if (plan.has("focal_blur")) lens_.emplace(database, run, images);
  }

  /// Traces the samples and adds them to the film in their order. `places` are empty if nothing is soft. A pixel must
  /// not be in the batches of two threads at a time. False if the run was stopped or refused meanwhile: the film gets
  /// none of them. `observer` may be null.
  [[nodiscard]] bool trace(std::span<const CameraSample> samples, std::span<const PixelSample> places,
                           Workspace& workspace, SampleObserver* observer = nullptr) const;

  [[nodiscard]] bool has_lens() const { return lens_.has_value(); }
  [[nodiscard]] const std::optional<scene::Refusal>& refusal() const {
    return quick_.refusal() ? quick_.refusal() : whole_.refusal();
  }

 private:
  /// Sets the camera rays of the samples; false if the camera's bumps take too many steps.
  [[nodiscard]] bool set_rays(std::span<const CameraSample> samples, Workspace& workspace) const;
  /// Bends the rays of the samples by the camera's bumps; false if that takes too many steps.
  [[nodiscard]] bool bend(std::span<const CameraSample> samples, std::span<Ray> rays) const;
  /// Traces the camera rays, with a tenth of their bound or, if that is not enough, with all of it.
  [[nodiscard]] bool trace_paths(std::span<const CameraSample> samples, Workspace& workspace,
                                 SurfaceObserver* observer) const;
  /// True if more than a thousandth as many rays take more than a tenth of their bound in vain as a lattice over the
  /// whole picture has pixels, every 31st in both directions.
  [[nodiscard]] bool is_hard(const Integrator& whole) const;
  /// Makes the samples black and clear whose colours are not finite, and the film lose them. By sample, 1 if it is
  /// lost.
  [[nodiscard]] std::vector<std::uint8_t> lose_samples(std::span<const CameraSample> samples, const PathMemory& paths,
                                                       std::span<Rgb> colours, std::span<double> alphas) const;
  /// Adds what the samples of memory.camera_rays() see to the film.
  void add(std::span<const CameraSample> samples, PathMemory& paths, SampleObserver* observer) const;
  /// Sets the rays of the samples, whose places among those of their pixels are known, through points of the lens.
  void set_blurred(std::span<const CameraSample> samples, Workspace& workspace) const;

  Tracer quick_tracer_;
  Integrator quick_;  ///< its rays take a tenth of their bound
  WholeBound whole_;
  CameraRays camera_;
  PixelRect picture_;
  OriginId camera_origin_;
  std::optional<CameraBumps> bumps_;  ///< if the camera has a `normal`
  std::optional<Lens> lens_;          ///< if it has focal blur
  WorkingSpace working_space_;
  double blank_alpha_;  ///< of samples where the camera shows nothing, which are black
  Film& film_;
};

}  // namespace isl::render
