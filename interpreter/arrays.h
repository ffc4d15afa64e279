// `array[2][3] { … }`: making arrays. Their elements are places (interpreter/places.h).
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// Makes an array and evaluates its initialiser; checks sizes and counts. Without dimensions the initialiser gives the
/// size; without both the array grows by use.
[[nodiscard]] Value make_array(Context& context, const grammar::Array& node);

}  // namespace isl::interpreter
