// The built-in functions of one or two numbers without their messages, for routines.
#pragma once

#include "grammar/symbols.h"

#include <cstddef>

namespace isl::interpreter {

struct NumberFunction {
  /// False where the built-in function fails or warns; the evaluator then calls that.
  using Apply = bool (*)(double a, double b, double& result);

  std::size_t arguments = 0;
  double (*of_one)(double) = nullptr;  ///< a function of one number that cannot fail
  Apply apply = nullptr;               ///< any other
};

/// The function of this name; null if it is none of numbers, or if its calls have side effects.
[[nodiscard]] const NumberFunction* number_function(grammar::Symbol name);

}  // namespace isl::interpreter
