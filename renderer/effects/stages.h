// The stages of following paths in which effects take part. A stage works on a whole batch, or on a block of its
// surface points, never on a single one. The integrator calls the stages of the plan in the order of the list of
// effects and knows none of them by name.
#pragma once

#include "renderer/paths/path.h"
#include "renderer/shading/lighting.h"
#include "renderer/shading/point_refusals.h"
#include "renderer/shading/point_textures.h"
#include "renderer/trace/tracer.h"

#include <memory>
#include <span>
#include <vector>

namespace isl::render {

/// The things that a rendering's stages are made from. They all outlive the stages.
struct StageContext {
  const scene::Database& database;
  const Tracer& tracer;
  const PointTextures& textures;
  PointRefusals& refusals;
};

/// Segments that were traced, before anything at their ends is shaded. Media along them change factors and add light.
struct AlongWork {
  PathBatch& batch;
  std::span<Rgb> colours;  ///< by sample
};

/// Segments that meet nothing.
struct MissWork {
  const PathBatch& batch;
  std::span<const std::uint32_t> misses;  ///< numbers in the batch
  Rgb background;                         ///< the colour that is seen where the stage lets light through
  double background_alpha;
  std::span<Rgb> colours;    ///< by sample
  std::span<double> alphas;  ///< by sample; empty except for camera rays
};

/// The points where some segments of a batch end, with their textures.
struct SurfaceBlock {
  std::vector<std::uint32_t> paths;  ///< numbers in the batch
  std::vector<ShadingPoint> points;

  void clear() {
    paths.clear();
    points.clear();
  }
};

struct SurfaceWork {
  const PathBatch& batch;
  const SurfaceBlock& block;
  std::span<Rgb> colours;  ///< by sample
};

/// A point of a block that one light may reach, because it faces the light.
struct LitPoint {
  std::uint32_t point = 0;  ///< number in the block
  LightSample light;
  double incidence = 0;  ///< N·L, above 0
  Rgb colour{0};         ///< the light that reaches the eye, before the light's own colour
};

/// The share of each of a lit point's textures in highlights, in the order of lit points and of their textures.
using Shine = std::vector<Rgb>;

struct LightWork {
  const SurfaceBlock& block;
  const scene::Light& light;
  std::span<LitPoint> lit;
  Shine& shine;  ///< empty in the stages before highlights
};

/// Segments that surfaces send on. They are traced after everything else of the batch.
struct SpawnWork {
  const PathBatch& batch;
  const SurfaceBlock& block;
  ChildQueues& children;
  EndedPaths& ended;
};

template <class Work>
class Stage {
 public:
  Stage() = default;
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  virtual ~Stage() = default;
  virtual void run(Work& work) const = 0;
};

template <class Work>
using MakeStage = std::unique_ptr<const Stage<Work>> (*)(const StageContext&);

/// Used in a record: `.along = make_stage<MistStage, AlongWork>`.
template <class Made, class Work>
std::unique_ptr<const Stage<Work>> make_stage(const StageContext& context) {
  return std::make_unique<const Made>(context);
}

/// The stages that an effect has; most have one.
struct StageMakers {
  MakeStage<AlongWork> along = nullptr;
  MakeStage<MissWork> miss = nullptr;
  MakeStage<SurfaceWork> own_light = nullptr;
  MakeStage<LightWork> diffuse = nullptr;
  MakeStage<LightWork> shine = nullptr;
  MakeStage<SpawnWork> spawn = nullptr;
  bool shadows = false;  ///< light goes through the queue of shadow rays
};

}  // namespace isl::render
