// Solver names, tolerances, and all other options of a tracer.
#pragma once

#include "renderer/rays/paper_switches.h"

#include <cstdint>
#include <string>

namespace isl::render {

enum class SolverName : std::uint8_t {
  hermite,
  paper,
  exact,
  iso,
  interval,
  lg,
  march,
  climb,
  sphere,
  segment,
  inclusion
};

/// Whether it is the published solver or one of its kin, which has its switches.
[[nodiscard]] inline bool is_published(SolverName name) { return name == SolverName::paper || name == SolverName::iso; }

/// Whether it is another way of finding a root in a cell, for comparison (solvers/baselines/rival_solver-inl.h).
[[nodiscard]] inline bool is_rival(SolverName name) { return name >= SolverName::interval; }

/// A length along the ray: in pixels of the ray's own footprint, or in scene units.
struct Tolerance {
  double value = 0.05;
  bool in_pixels = true;

  friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

struct TracerOptions {
  SolverName solver = SolverName::hermite;
  int interpolants = 2;  ///< of `paper:K`
  PaperSwitches paper;   ///< of `paper` and `iso`
  Tolerance tolerance;
  Tolerance step{1, true};    ///< of those that march
  double relaxation = 1;      ///< of sphere tracing, in [1, 2)
  bool octree = false;        ///< of `lg`: cells culled as its authors have it, instead of those of all solvers
  double pixel_angle = 1e-3;  ///< radians a pixel subtends at the eye, for tolerances in pixels
  bool packets = true;        ///< of the product: rays in packets of eight, not one by one
  bool skeleton = false;      ///< every blob as its skeleton model (scene::Blob::is_skeleton)
  std::string simd;           ///< "" for the best the machine has, or a Highway target name ("AVX2")
};

}  // namespace isl::render
