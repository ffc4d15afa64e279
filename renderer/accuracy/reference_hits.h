// The truth that solvers are measured against: the first surface on each ray. Blobs are judged by renderer/reference,
// in long double and by proof, which shares no evaluator, no stopping rule and no grid with any solver. Solids have
// closed forms, and combinations hide which surface counts: their surfaces are the tracer's, and such rays are told
// apart.
#pragma once

#include "base/budget.h"
#include "renderer/accuracy/ray_measures.h"
#include "renderer/csg/expansion.h"
#include "renderer/reference/box_tree.h"
#include "renderer/reference/reference_field.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace isl::render {

enum class Knowledge : std::uint8_t {
  proven,     ///< by the judge, and for solids beside it by the tracer
  trusted,    ///< the surface is a solid's or a combination's, found by the tracer; no blob lies before it
  undecided,  ///< a blob is touched within the rounding of long double, before the hit or where there is none
};

struct ReferenceHit {
  double t = 0;      ///< along the ray, scene units; infinite for a miss
  double slack = 0;  ///< the surface lies within t ± slack, the rounding of t included
  Knowledge knowledge = Knowledge::proven;

  [[nodiscard]] bool is_miss() const { return t == std::numeric_limits<double>::infinity(); }
};

/// Immutable; every member may be called from many threads.
class ReferenceHits {
 public:
  /// Takes what it needs of the database: that may go. Charges the budget of the options' run.
  ReferenceHits(const scene::Database& database, const TracerOptions& options);

  /// The reason why the truth takes more memory than the run allows; there is then nothing to meet. If the run is
  /// stopped meanwhile, there is nothing to meet either.
  [[nodiscard]] const std::optional<scene::Refusal>& refusal() const { return refusal_; }

  /// Precondition: the ray does not start on a surface.
  [[nodiscard]] ReferenceHit first_hit(const Ray& ray) const;

  /// hits[i] becomes the hit of rays[i], on as many threads as loops have here. Once `stop` is true, the rest stays as
  /// it is.
  void find(std::span<const Ray> rays, std::span<ReferenceHit> hits, const StopFlag* stop = nullptr,
            const TellProgress& tell = {}) const;

 private:
  /// A blob in the world.
  struct Placed {
    std::shared_ptr<const reference::ReferenceField> field;
    scene::Matrix object_from_world;
    reference::Box bounds;
  };

  /// False if the sorted objects take more memory than is left.
  [[nodiscard]] bool take_memory(const scene::Database& database, const Expansion& expansion);

  Charge charge_;  ///< of all but `others_`
  std::optional<scene::Refusal> refusal_;
  std::vector<Placed> blobs_;
  reference::BoxTree bounds_;
  /// All that is no blob of its own, and the tracer that needs it; empty if there is nothing else.
  std::unique_ptr<const scene::Database> rest_;
  std::optional<Tracer> others_;
};

/// How much of a picture's truth is known.
struct ReferenceSummary {
  std::uint64_t rays = 0;
  std::uint64_t proven = 0, trusted = 0, undecided = 0;  ///< their number, by Knowledge
  double worst_pixels = 0;                               ///< the greatest slack of the proven hits
};

/// `pixel_angle` as in TracerOptions.
[[nodiscard]] ReferenceSummary summarise_reference(std::span<const Ray> rays, std::span<const ReferenceHit> hits,
                                                   double pixel_angle);

}  // namespace isl::render
