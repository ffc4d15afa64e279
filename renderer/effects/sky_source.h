// The sky as a source of light: what the stages of segments that meet nothing show, by direction. Directions are chosen
// partly by a table of its brightness, which finds suns and windows, and partly by the cosine to the surface, which is
// best for an even sky.
#pragma once

#include "renderer/effects/stages.h"
#include "renderer/numerics/density_table.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace isl::render {

class SkySource {
 public:
  /// Makes the table. The stages must outlive it. `background` is what the sky lets through.
  SkySource(std::span<const std::unique_ptr<const Stage<MissWork>>> stages, const Rgb& background);

  /// The light from each direction; `batch` is working memory.
  void light(std::span<const Vec3> directions, std::span<Rgb> light, PathBatch& batch) const;

  /// A direction, and the density over the sphere (per steradian) with which it is chosen.
  struct Choice {
    Vec3 direction;
    double density;
  };
  /// The direction that belongs to a point of the unit square, for a surface with this unit normal.
  [[nodiscard]] Choice choose(const UnitPoint& at, const Vec3& normal) const;

 private:
  std::span<const std::unique_ptr<const Stage<MissWork>>> stages_;
  Rgb background_;
  std::optional<DensityTable> table_;
  double by_table_ = 0;  ///< the share of directions that the table chooses
};

}  // namespace isl::render
