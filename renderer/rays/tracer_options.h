// Solver names, tolerances, and all other options of a tracer.
#pragma once

#include "base/run_limits.h"
#include "renderer/rays/paper_switches.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace isl::render {

enum class SolverName : std::uint8_t {
#define ISL_SOLVER(word, family, argument) word,
#include "renderer/rays/solvers.def"
};

/// The certified solver, Sherstyuk's published one with its kin, or another way of finding a root in a cell, for
/// comparison.
enum class SolverFamily : std::uint8_t { product, published, rival };

/// The kind of text that may follow the solver's name.
enum class SolverArgument : std::uint8_t { none, interpolants, step, relaxation, octree, way };

struct NamedSolver {
  std::string_view word;
  SolverName name;
  SolverFamily family;
  SolverArgument argument;
};
/// In the order of SolverName.
inline constexpr NamedSolver kSolvers[] = {
#define ISL_SOLVER(word, family, argument) {#word, SolverName::word, SolverFamily::family, SolverArgument::argument},
#include "renderer/rays/solvers.def"
};

[[nodiscard]] constexpr SolverFamily family_of(SolverName name) {
  return kSolvers[static_cast<std::size_t>(name)].family;
}

/// True of the published solver and its kin, which have its switches.
[[nodiscard]] constexpr bool is_published(SolverName name) { return family_of(name) == SolverFamily::published; }

/// True of the solvers in renderer/solvers/baselines, which are a module of their own (renderer/rivals).
[[nodiscard]] constexpr bool is_rival(SolverName name) { return family_of(name) == SolverFamily::rival; }

/// A length along the ray: in pixels of the ray's own footprint, or in scene units.
struct Tolerance {
  double value = 0.05;
  bool in_pixels = true;

  friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

struct TracerOptions {
  SolverName solver = SolverName::hermite;
  int interpolants = 2;  ///< for `paper:K`
  PaperSwitches paper;   ///< for `paper` and `iso`
  Tolerance tolerance;
  Tolerance step{1, true};    ///< for methods that march
  double relaxation = 1;      ///< for sphere tracing, in [1, 2)
  bool octree = false;        ///< for `lg`: cells are culled by its authors' method instead of the common one
  double pixel_angle = 1e-3;  ///< radians a pixel subtends at the eye, for tolerances in pixels
  bool packets = true;        ///< for the product's solver: rays in packets of eight, not one by one
  bool digits = false;     ///< for the product's solver: places every crossing with more digits than double precision
  bool unblended = false;  ///< every blob is drawn unblended (scene::Blob::is_unblended)
  RunLimits run;           ///< of compiling the scene and of each ray; its flag also ends the tracing of a batch early
  /// Limit of the cells and lists of all grids. A smaller grid is right and slower to trace.
  std::size_t most_grid_bytes = std::numeric_limits<std::size_t>::max();
  std::string simd;  ///< "" for the widest target that the machine has, or a Highway target name ("AVX2")
};

}  // namespace isl::render
