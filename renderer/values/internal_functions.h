// The functions that are built into POV-Ray and named in its `functions.inc`: `function { internal(n) }`. Surfaces are
// scalar fields by their published formulas; the numbers of the functions, their signs and their clamps follow POV-Ray,
// as observed.
#pragma once

#include <span>
#include <string_view>

namespace isl::values {

struct InternalFunction {
  std::string_view name;     ///< its name in functions.inc; empty if POV-Ray has none of this number
  int extra_parameters = 0;  ///< after x, y, z
  /// The value at p[0], p[1], p[2] with the parameters from p[3] on; null if the formula is not known here.
  double (*evaluate)(const double* p) = nullptr;
  /// The scene's noise generator is passed in p[3].
  bool takes_scene_noise = false;

  [[nodiscard]] bool exists() const { return !name.empty(); }
};

/// The functions, by number.
[[nodiscard]] std::span<const InternalFunction> internal_functions() noexcept;

}  // namespace isl::values
