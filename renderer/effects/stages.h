// The stages of following paths in which effects take part. A stage works on a whole batch, or on a block of its
// surface points, never on a single one. The integrator calls the stages of the plan in the order of the list of
// effects and knows none of them by name.
#pragma once

#include "renderer/paths/bent_light.h"
#include "renderer/paths/contacts.h"
#include "renderer/paths/path.h"
#include "renderer/paths/pixel_sample.h"
#include "renderer/paths/shadow_queue.h"
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
  const LitTexture* textures = nullptr;  ///< those of all points, one point after the other
  /// The normals of `textures`, as bumps turn them. Empty if no effect turns normals: then a point's textures have its
  /// own.
  std::vector<Vec3> normals;
  /// LayerLists::passing of `textures`. Empty if no effect asks for it.
  std::vector<Rgb> passing;
  /// LayerLists::opacities of `textures`. Empty if no effect asks for it.
  std::vector<double> opacities;

  void clear() {
    paths.clear();
    points.clear();
    normals.clear();
    passing.clear();
    opacities.clear();
  }
  [[nodiscard]] const Vec3& normal_of(const ShadingPoint& point, const LitTexture& texture) const {
    return normals.empty() ? point.normal : normals[static_cast<std::size_t>(&texture - textures)];
  }
  [[nodiscard]] const Rgb& passing_of(const LitTexture& texture) const {
    return passing[static_cast<std::size_t>(&texture - textures)];
  }
  /// The share of the texture's highlights and reflection that is seen: with `use_alpha`, its opacity.
  [[nodiscard]] double surface_share_of(const LitTexture& texture) const {
    if (opacities.empty() || !texture.material->finish->use_alpha) return 1;
    return opacities[static_cast<std::size_t>(&texture - textures)];
  }
};

/// The textures of a block before any light falls on them. A stage changes how much of it they throw back.
struct TextureWork {
  const SurfaceBlock& block;
  std::span<LitTexture> textures;  ///< those of all points, one point after the other
};

struct SurfaceWork {
  const PathBatch& batch;
  const SurfaceBlock& block;
  std::span<Rgb> colours;  ///< by sample
};

/// The light that goes towards each point of a block.
struct ReachWork {
  const PathBatch& batch;
  const SurfaceBlock& block;
  const scene::Light& light;
  std::uint32_t light_group = scene::kNone;  ///< the light's, as Tracer::light_groups() counts; kNone: the world's
  std::span<LightSample> samples;            ///< by point
};

/// A point of a block that one light may reach, because it faces the light.
struct LitPoint {
  std::uint32_t point = 0;  ///< number in the block
  LightSample light;
  double incidence = 0;  ///< N·L, above 0; meaningless if LightWork has cosines
  Rgb colour{0};         ///< the light that reaches the eye, before the light's own colour
};

/// The share of each of a lit point's textures in highlights, in the order of lit points and of their textures.
using Shine = std::vector<Rgb>;

struct LightWork {
  const PathBatch& batch;
  const SurfaceBlock& block;
  const scene::Light& light;
  std::span<LitPoint> lit;
  /// N·L of each of the lit points' textures, in the order of Shine: 0 where the light does not count, below 0 where it
  /// comes from behind. Empty if all textures of a point have its own incidence.
  std::span<const double> cosines;
  Shine& shine;  ///< empty in the stages before highlights
};

/// Calls visit(lit, texture, cosine, i) with each texture of each lit point, where i counts them.
template <class Visit>
void for_each_lit_texture(const LightWork& work, Visit&& visit) {
  std::size_t i = 0;
  for (LitPoint& lit : work.lit) {
    for (const LitTexture& texture : work.block.points[lit.point].textures) {
      visit(lit, texture, work.cosines.empty() ? lit.incidence : work.cosines[i], i);
      ++i;
    }
  }
}

class SkySource;

/// The places of a batch's samples among those of their pixels.
struct SamplePlaces {
  std::span<const PixelSample> samples;  ///< by camera sample
  const BentLight& bent;

  [[nodiscard]] const PixelSample& operator()(const PathEntry& path) const {
    return samples[bent.camera_sample(path.sample)];
  }
};

/// Light that comes to a block's points from around, from one direction a point in each call of a stage. A sample has
/// its share of a pixel's directions, so that stages are called until all say that this call was the last.
struct AroundWork {
  const PathBatch& batch;
  const SurfaceBlock& block;
  SamplePlaces sample_of;
  const SkySource* sky;    ///< null if no stage asks for it
  ShadowQueue& rays;       ///< gets the light that counts if nothing is in the way
  std::uint32_t turn = 0;  ///< the number of the call
  bool is_last = true;     ///< a stage that has directions left makes it false
  // Working memory of the stages.
  std::vector<Vec3>& directions;
  std::vector<Rgb>& colours;
  std::vector<Rgb>& light;
  PathBatch& scratch;
};

/// Segments that surfaces send on. They are traced after everything else of the batch.
struct SpawnWork {
  const PathBatch& batch;
  const SurfaceBlock& block;
  ChildQueues& children;
  PathLists& lists;
  const Tracer& tracer;
  std::span<std::uint8_t>
      is_total;  ///< by point: true if all light is reflected within the surface, whatever it is like
  EndedPaths& ended;
  BentLight& bent;
  SamplePlaces sample_of;  ///< if there is a soft effect

  /// Queues a segment from a surface on.
  void send(const Ray& ray, PathEntry path) {
    path.contact = lists.contacts.next(path.contact, ray.direction, path.kind, tracer);
    children.push(ray, path);
  }
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
#ifdef ISL_LEAVES_STAGES_OUT  // CMakeLists.txt
template <class Made, class Work>
inline constexpr MakeStage<Work> make_stage = nullptr;
#else
template <class Made, class Work>
std::unique_ptr<const Stage<Work>> make_stage(const StageContext& context) {
  return std::make_unique<const Made>(context);
}
#endif

/// The stages that an effect has; most have one.
struct StageMakers {
  MakeStage<AlongWork> along = nullptr;
  MakeStage<MissWork> miss = nullptr;
  MakeStage<TextureWork> textures = nullptr;
  MakeStage<SurfaceWork> own_light = nullptr;
  MakeStage<ReachWork> reach = nullptr;
  MakeStage<LightWork> diffuse = nullptr;
  MakeStage<LightWork> shine = nullptr;
  MakeStage<LightWork> dim = nullptr;  ///< after all others of the light: what it loses on its way
  MakeStage<AroundWork> around = nullptr;
  MakeStage<SpawnWork> spawn = nullptr;
  bool sky = false;         ///< the sky is a source of light
  bool windows = false;     ///< some lights shine only through an object
  bool shadows = false;     ///< light goes through the queue of shadow rays
  bool back_light = false;  ///< some textures are lit from behind
  bool bumps = false;       ///< every texture of a point has a normal of its own
  bool mirrors = false;     ///< surfaces mirror light
  bool fresnel = false;     ///< what surfaces mirror depends on the media on both sides
  bool passing = false;     ///< textures let light through: that which is seen, and that of lights
  bool opacities = false;   ///< the opacity of textures counts besides what they let through; with `passing`
};

}  // namespace isl::render
