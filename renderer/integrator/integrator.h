// Paths in batches: a batch of camera rays → hits → what lies along the rays and behind them → blocks of surface
// points, their own light and that of the lights → shadow rays → rays that surfaces send on, a level deeper each time →
// colours of the samples. One thread works on a batch from beginning to end; its memory is kept for the next batch and
// stays in the cache.
//
// The integrator runs the stages of the effects in the plan (effects/stages.h) and knows none of the effects. It
// recurses over batches, at most max_trace_level deep, and never over single rays.
#pragma once

#include "renderer/effects/plan.h"
#include "renderer/effects/sky_source.h"
#include "renderer/integrator/placed_lights.h"
#include "renderer/paths/area_shadows.h"
#include "renderer/paths/light_windows.h"
#include "renderer/paths/pixel_sample.h"
#include "renderer/paths/place_order.h"
#include "renderer/paths/shadow_queue.h"
#include "renderer/paths/soft_points.h"
#include "renderer/shading/area_grid.h"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

namespace isl::render {

/// Segments traced together: enough for full vectors, small enough that a thread's memory stays in its second-level
/// cache.
inline constexpr std::size_t kBatchSize = 1024;

/// Points that are shaded together: their textures and the light they get from one light source fit the first-level
/// cache.
inline constexpr std::size_t kBlockSize = 64;

/// The common data of all rays that go from one lit point to the points of an area light.
struct TowardsArea {
  const PathEntry* path = nullptr;
  Rgb colour{0};    ///< for each of them
  Ray middle;       ///< to the light's centre
  AreaEdges edges;  ///< as the lit point sees them
};

/// Memory of one thread.
struct PathMemory {
  struct Level {
    PathBatch batch;
    ChildQueues children;
    std::vector<std::uint32_t> met, misses;  ///< the numbers of the rays that meet something, and of the others
    std::size_t children_counted = 0;        ///< of these segments the memory is charged
  };
  std::deque<Level> levels{1};  ///< 0 is the camera's; a level stays where it is while deeper ones are made
  std::vector<Rgb> colours;     ///< by sample, in the scene's working space
  std::vector<double> alphas;
  std::vector<Certainty> certainties;  ///< by sample: the worst of all its rays
  /// By camera sample, if the integrator is soft. All of a batch share points with as many others (PixelSample::of).
  std::vector<PixelSample> pixel_samples;
  ShadowQueue shadows{RayKind::shadow};
  ShadowQueue around{RayKind::around};
  AreaShadows area_shadows;
  std::array<std::vector<double>, 2> area_weights;  ///< of the present light's grid, along both edges
  std::vector<TowardsArea> towards_area;            ///< of the lit points that are asked for together
  SurfaceBlock block;
  BentLight bent;
  std::size_t samples_counted = kBatchSize;  ///< of these samples the memory is charged, or need not be
  PathLists lists;                           ///< of the paths of the present camera rays
  std::vector<CoincidingHit> coinciding;     ///< of the present batch
  std::vector<std::uint8_t> is_total;        ///< SpawnWork::is_total
  ShadowFilterMemory shadow_filter;
  std::array<BlobFields, kBlockSize> blob_fields;  ///< of the block's points
  SurfacePoint surface;
  std::vector<Vec3> directions;  ///< these four serve the stages of light from around
  std::vector<Rgb> direction_colours, direction_light;
  PathBatch direction_batch;
  std::vector<LitTexture> textures;  ///< the textures of the block's points
  Charge queue_bytes;                ///< of the segments that wait, at all levels
  Charge texture_bytes;              ///< of `textures`
  std::array<LitPoint, kBlockSize> lit;
  std::array<LightSample, kBlockSize> samples;
  std::vector<double> cosines;
  Shine shine;
  std::vector<SoftPlace> places;  ///< of points that are asked for together
  std::vector<UnitPoint> points;  ///< those points
  PlaceOrder by_place;
  PathCounts counts;
  TraceCounters counters;

  /// The caller fills these before each call of Integrator::trace.
  [[nodiscard]] std::vector<Ray>& camera_rays() { return levels.front().batch.rays; }
  /// Sets `points` to those of `places`.
  void set_points() {
    points.resize(places.size());
    render::set_points(places, points);
  }
  [[nodiscard]] const PixelSample& pixel_sample(std::uint32_t sample) const {
    return pixel_samples[bent.camera_sample(sample)];
  }
};

/// Is told of the first surfaces that camera rays meet, for layers. Misses are not told.
class SurfaceObserver {
 public:
  virtual ~SurfaceObserver() = default;
  /// `ray` is the number of the camera ray in its batch.
  virtual void see(std::uint32_t ray, const Hit& hit, const SurfacePoint& surface, const ShadingPoint& point) = 0;
};

/// The state that all batches of a rendering share; immutable. Everything that it refers to must outlive it.
/// `images` may be null if the plan calls for none.
class Integrator {
 public:
  Integrator(const scene::Database& database, const Tracer& tracer, const Plan& plan, bool transparent_background,
             const RunLimits& run = {}, const ImageTable* images = nullptr);
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;

  /// Traces memory.camera_rays(). Afterwards memory.colours[i] and memory.alphas[i] are what ray number i sees, and
  /// memory.certainties[i] how sure that is.
  /// `observer` may be null. False if the run was stopped or refused meanwhile: the colours are then meaningless.
  [[nodiscard]] bool trace(PathMemory& memory, SurfaceObserver* observer) const;

  /// True if there is something soft that has to be sampled, so that the caller fills memory.pixel_samples, too.
  [[nodiscard]] bool is_soft() const { return soft_; }

  /// Refuses the rendering because the patterns of a thing, made at `origin`, take too long at a point.
  void refuse(std::string_view thing, OriginId origin) const { refusals_.report(thing, origin); }
  /// Why the rendering cannot go on, once trace() has returned false; null if it was stopped.
  [[nodiscard]] const std::optional<scene::Refusal>& refusal() const { return refusals_.refusal(); }

 private:
  void make_windows();
  void run_level(std::size_t level, PathMemory& memory, SurfaceObserver* observer) const;
  /// Drops the segments and shadow rays that wait, so that the next batch begins without them.
  static void give_up(std::size_t level, PathMemory& memory);
  /// Finds where the segments end. Those that end at a contact, and do not yet know it, learn of it.
  void find_hits(PathBatch& batch, PathMemory& memory) const;
  /// Lists the rays of a level that meet something, and the others, and notes how sure their hits are.
  static void tell_apart(std::size_t level, PathMemory& memory);
  /// Makes room for the samples of `bent`, or drops those that are finished.
  static void resize_samples(PathMemory& memory);
  void see_background(std::size_t level, const PathBatch& batch, PathMemory& memory) const;
  void shade_surfaces(std::size_t level, PathMemory& memory, SurfaceObserver* observer) const;
  void fill_block(const PathBatch& batch, PathMemory& memory, SurfaceObserver* observer) const;
  void shade_block(std::size_t level, PathMemory& memory) const;
  void light_from_around(const PathBatch& batch, PathMemory& memory) const;
  // The following functions light a block (lighting.cpp).
  /// Fills memory.lit with the block's points that the light may reach, and memory.cosines if textures of a point may
  /// differ in that. The number of the points.
  [[nodiscard]] std::size_t face_light(const PathBatch& batch, const PlacedLight& placed, PathMemory& memory) const;
  /// The same, with cosines, where memory.samples are the ways to the light.
  [[nodiscard]] std::size_t face_samples(const PathBatch& batch, const PlacedLight& placed, PathMemory& memory) const;
  /// True if light may come with less than its full strength (LightSample::strength).
  [[nodiscard]] bool has_strengths() const { return !reach_.empty() || windows_; }
  /// True if the rays to the light are those to the points of its area, so that the ray to its centre does not count.
  [[nodiscard]] bool throws_soft_shadows(const scene::Light& light) const {
    return light.area && shadows_ && !light.shadowless;
  }
  /// Lets memory.samples end at the light's window; light that does not come through it loses its strength.
  void pass_window(const scene::Light& light, PathMemory& memory) const;
  /// Appends the cosines of a point's textures (LightWork::cosines); false, with nothing appended, if all are 0.
  [[nodiscard]] bool add_cosines(const SurfaceBlock& block, const ShadingPoint& point, const LightSample& sample,
                                 std::vector<double>& cosines) const;
  /// The first `count` of memory.lit, with the light that they throw back where nothing is in the way: of a light of
  /// the colour 1.
  [[nodiscard]] std::span<LitPoint> throw_back(const PathBatch& batch, const scene::Light& light, std::size_t count,
                                               PathMemory& memory) const;
  /// All points of the block, lit by the points of an area light with `area_illumination`, each of which has its share
  /// of the light.
  [[nodiscard]] std::span<LitPoint> throw_back_from_area(const PathBatch& batch, const PlacedLight& placed,
                                                         PathMemory& memory) const;
  /// The number of points of the light from which each point of the block is lit.
  [[nodiscard]] static std::uint32_t points_of(const PathBatch& batch, const PlacedLight& placed,
                                               const PathMemory& memory);
  /// Sets memory.samples to the ways from the block's points to one of these each; `centres` are those to the light's
  /// middle.
  void aim_at_area(const PathBatch& batch, const PlacedLight& placed, std::span<const LightSample> centres,
                   std::uint32_t number, PathMemory& memory) const;
  void light_block(const PathBatch& batch, const PlacedLight& placed, PathMemory& memory) const;
  /// Sets all of the ray from a lit point to the light.
  static void set_way(const PathBatch& batch, const LitPoint& lit, const SurfaceBlock& block, Ray& ray);
  /// Queues the ray to a point of an area light; `to_light` leads to its centre.
  void push_ray(const scene::Light& light, const Vec3& source, const Ray& to_light, const PathEntry& path,
                const Rgb& colour, PathMemory& memory) const;
  /// Queues the rays to all points of an area light.
  void push_area(const scene::Light& light, const Ray& to_light, const PathEntry& path, const Rgb& colour,
                 PathMemory& memory) const;
  /// True if the one sample that takes all points of a jittered light's grid may take fewer, as `adaptive` says.
  [[nodiscard]] static bool takes_adaptive_grid(const PlacedLight& placed, const PathBatch& batch,
                                                const PathMemory& memory);
  /// Sets memory.points to the samples' shares of points at random on an area light, one lit point after the other.
  static void set_area_points(const PathBatch& batch, const PlacedLight& placed, std::span<const LitPoint> lit_points,
                              std::uint32_t share, PathMemory& memory);
  /// Queues the rays to these points, of camera rays those to neighbouring points of the light together.
  void push_scattered(const PathBatch& batch, const PlacedLight& placed, std::span<const LitPoint> lit_points,
                      PathMemory& memory) const;
  /// Traces the shadow rays that wait if they are many.
  void trace_long_queues(PathMemory& memory) const;
  void trace_shadows(PathMemory& memory) const;
  /// Adds the light of the rays of a queue that nothing stops.
  void resolve(ShadowQueue& queue, std::uint64_t& count, PathMemory& memory) const;
  void trace_children(std::size_t level, PathMemory& memory) const;
  /// Charges the memory of the segments that wait at a level. A surface of many mirrors, seen in many mirrors, makes
  /// millions of them.
  void charge_children(std::size_t level, PathMemory& memory) const;

  /// True if the batch brings light from surfaces to others.
  [[nodiscard]] static bool is_around(const PathBatch& batch) {
    return batch.size() != 0 && batch.entries.front().kind == RayKind::around;
  }
  /// True if the rest of a batch need not be traced.
  [[nodiscard]] bool is_over() const noexcept { return is_set(run_.stop) || refusals_.is_set(); }

  template <class Work>
  using Stages = std::vector<std::unique_ptr<const Stage<Work>>>;
  template <class Work>
  static void run(const Stages<Work>& stages, Work& work) {
    for (const auto& stage : stages) stage->run(work);
  }

  const scene::Database& database_;
  const Tracer& tracer_;
  RunLimits run_;
  mutable PointRefusals refusals_;
  std::vector<PlacedLight> lights_;
  PointTextures textures_;
  Stages<AlongWork> along_;
  Stages<MissWork> miss_;
  Stages<TextureWork> texture_stages_;
  Stages<SurfaceWork> own_light_;
  Stages<ReachWork> reach_;
  Stages<LightWork> diffuse_, shine_, dim_;
  Stages<AroundWork> around_;
  Stages<SpawnWork> spawn_;
  bool soft_ = false;
  bool shadows_ = false, back_light_ = false, bumps_ = false, passing_ = false, opacities_ = false, mirrors_ = false;
  std::optional<SkySource> sky_;               ///< if it is a source of light
  std::optional<LightWindows> windows_;        ///< if some lights shine only through an object
  std::optional<Interiors> interiors_;         ///< if some surface mirrors by their refraction
  std::optional<ShadowFilter> shadow_filter_;  ///< if surfaces let light through
  Rgb background_{0};
  double background_alpha_ = 1;
  bool camera_in_solid_ = false;
  std::vector<Body> camera_bodies_;  ///< in which paths begin
};

}  // namespace isl::render
