// Soft shadows of area lights with `adaptive`. A part of the light's grid (shading/area_grid.h) is divided where its
// corners are lit differently, so rays depend on the answers of others. Many lit points are estimated together, round
// by round: each round traces the corners of all parts that the round before divided. With `jitter` each
// point of the grid stands at a place of its own, at most half of the way to the next point away.
#pragma once

#include "base/budget.h"
#include "renderer/paths/shadow_tracer.h"
#include "renderer/shading/area_grid.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace isl::render {

/// A lit point that waits for its shadow.
struct AreaTarget {
  const scene::Light* light = nullptr;
  std::uint32_t sample = 0;
  LightBegin begins;
  Rgb colour{0};  ///< the light that the sample gets if nothing stands in the way
  Rgb arriving{
      0};         ///< the light that then arrives at the point: parts are divided where shadows make a difference in it
  Ray to_centre;  ///< leads from the point to the light's centre
  std::optional<std::uint32_t> jitter_seed = {};
};

/// Its memory is kept from batch to batch.
class AreaShadows {
 public:
  /// Memory is charged to `charge`.
  void charge_to(Charge charge) { charge_ = std::move(charge); }
  void clear();
  /// False if there is no memory for the light's grid.
  [[nodiscard]] bool push(const AreaTarget& target);
  /// True if the points that wait hold as much memory as is worth while.
  [[nodiscard]] bool is_full() const { return answers_at_.size() >= kManyCells; }
  [[nodiscard]] bool is_empty() const { return targets_.empty(); }

  /// Adds the light of every target to colours[sample], in the order of pushing; certainties[sample] falls where a ray
  /// is undecided. The number of rays traced.
  std::uint64_t resolve(const ShadowTracer& tracer, std::span<Rgb> colours, std::span<Certainty> certainties);

 private:
  /// Points of grids that are estimated together: their answers stay in a second-level cache.
  static constexpr std::size_t kManyCells = 0x8000;
  static constexpr std::uint32_t kNotAsked = 0xFFFFFFFF, kNoLight = 0xFFFFFFFE;

  struct Estimate {
    AreaTarget target;
    AreaEdges edges;
    std::size_t first_cell;  ///< of its grid, in answers_at_
    Rgb share{0};            ///< of the light, from the parts that are not divided any more
  };
  struct Part {
    std::uint32_t target;
    int level;
    double weight;
    AreaPart part;
  };

  /// The share of light that comes from a grid point, once it is known.
  [[nodiscard]] Rgb share_from(const Estimate& estimate, int u, int v);
  /// The place of a grid point's answer, which is asked for if it has not been.
  std::uint32_t& answer_at(const Estimate& estimate, int u, int v);
  void ask(const ShadowTracer& tracer, const Estimate& estimate, int u, int v);
  /// Takes the estimate of a part, or divides it.
  void finish(const Part& part);

  std::vector<Estimate> targets_;
  std::vector<std::uint32_t> answers_at_;  ///< by grid point of every target: the number of its ray, if it has one
  std::vector<Part> parts_, divided_;
  std::vector<Ray> rays_;               ///< of this round
  std::vector<Rgb> answers_;            ///< of all rounds, by ray
  std::vector<std::uint32_t> samples_;  ///< by ray of this round
  std::vector<LightBegin> begin_in_;    ///< likewise
  std::vector<Certainty> certainties_;
  std::vector<std::uint8_t> occluded_;
  Charge charge_;
};

}  // namespace isl::render
