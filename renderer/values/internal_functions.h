// The functions that POV-Ray builds in and its `functions.inc` names: `function { internal(n) }`. Surfaces as scalar
// fields by their published formulas; which number is which, and signs and clamps, are POV-Ray's as its program
// answers.
#pragma once

#include <span>
#include <string_view>

namespace isl::values {

struct InternalFunction {
  std::string_view name;     ///< as functions.inc has it; empty where POV-Ray has none of this number
  int extra_parameters = 0;  ///< after x, y, z
  /// The value at p[0], p[1], p[2] with the parameters from p[3] on; null where the formula is not known here.
  double (*evaluate)(const double* p) = nullptr;
  /// The scene's noise generator is to stand in p[3].
  bool takes_scene_noise = false;

  [[nodiscard]] bool exists() const { return !name.empty(); }
};

/// By number.
[[nodiscard]] std::span<const InternalFunction> internal_functions() noexcept;

}  // namespace isl::values
