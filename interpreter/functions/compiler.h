// The body of `function(a, b) { expression }` → a program. Numeric identifiers are captured with their present value;
// macros and directives in the body are executed now. The parser has given the operators the precedences of functions.
#pragma once

#include "interpreter/context.h"

#include <span>

namespace isl::interpreter {

/// Fails if the body is not an expression of numbers, parameters and functions. `span` is the whole function's.
[[nodiscard]] scene::Function compile_function(Context& context, std::span<const grammar::Symbol> parameters,
                                               grammar::Items body, SourceSpan span);

}  // namespace isl::interpreter
