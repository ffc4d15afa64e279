// `array[2][3] { … }` and `A[i][j]`: making arrays and finding their elements.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// Makes an array and evaluates its initialiser; checks sizes and counts.
[[nodiscard]] Value make_array(Context& context, const grammar::Array& node);

/// The slot of an element. Null if `may_be_undeclared` and the array itself is not declared or has too few dimensions;
/// every other mistake (no array, an index out of range) fails.
[[nodiscard]] Slot* find_element(Context& context, const grammar::Index& node, bool may_be_undeclared);

/// Fails if an array with this element would be deeper than values may be.
void check_array_nesting(Context& context, const Value& element, SourceSpan span);

}  // namespace isl::interpreter
