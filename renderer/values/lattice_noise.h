// The sums of lattice noise (noise.h). They are computed for every vector width.
#pragma once

#include "renderer/scene/transform.h"
#include "renderer/values/noise.h"

#include <span>

namespace isl::values {

struct NoiseTables;

/// Σ over the corners of the cell around p: weight · (half of the value + slope · (p − corner)).
[[nodiscard]] double lattice_sum(const scene::Vec3& p) noexcept;
/// sums[i] is that sum at scale · λⁱ · p.
void lattice_octaves(const scene::Vec3& p, double scale, double lambda, std::span<double> sums) noexcept;
/// Three such sums at λⁱp, times ωⁱ, added up over i from 0 to octaves.count − 1.
[[nodiscard]] scene::Vec3 lattice_vector_sum(const scene::Vec3& p, const Octaves& octaves) noexcept;

/// The same for one vector width.
struct LatticeSums {
  double (*sum)(const NoiseTables&, const scene::Vec3&);
  void (*octaves)(const NoiseTables&, const scene::Vec3&, double scale, double lambda, std::span<double> sums);
  scene::Vec3 (*vector_sum)(const NoiseTables&, const scene::Vec3&, const Octaves&);
};

}  // namespace isl::values
