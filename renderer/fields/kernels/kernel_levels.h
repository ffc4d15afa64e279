// Bounds of a kernel's profile φ(v) and of the v at which it has a given value, from a table, in a fraction of the time
// that φ takes. Kernels are convex (kernel_bounds-inl.h), so the chord between two values of the table lies above φ.
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"

#include <array>

namespace isl::render {

class KernelLevels {
 public:
  /// Precondition: !kernel.is_convolved, whose φ is not defined.
  explicit KernelLevels(const KernelConstants& kernel);

  /// An upper bound of φ(v), v ≥ 0; 0 beyond the support.
  [[nodiscard]] double most_at(double v) const;

  /// An upper bound of all v at which φ(v) is at least this; negative if there is none. Precondition: level > 0.
  [[nodiscard]] double farthest_with(double level) const;

 private:
  static constexpr int kPieces = 64;

  double piece_;  ///< the length of a piece, in v
  double per_piece_;
  std::array<double, kPieces + 1> values_;  ///< of φ at multiples of piece_
};

}  // namespace isl::render
