// The body of `function(a, b) { expression }` → a program. Identifiers that stand for numbers are captured as they are
// now; macros and directives in the body are followed now. The parser has given the operators the precedences that hold
// here.
#pragma once

#include "interpreter/context.h"

#include <span>

namespace isl::interpreter {

/// Fails where the body is no expression of numbers, parameters and functions. `span` is the whole function's.
[[nodiscard]] scene::Function compile_function(Context& context, std::span<const grammar::Symbol> parameters,
                                               grammar::Items body, SourceSpan span);

}  // namespace isl::interpreter
