// Functions and splines as values: made from `function …` and `spline { … }`, and called by a scene's expressions.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// `function (a, b) { … }`: an expression, `internal(n)`, or one of the blocks that a function can hold.
[[nodiscard]] Value make_function(Context& context, const grammar::Function& node);

inline constexpr std::size_t kMaxParameters = 56;  ///< POV-Ray's limit

/// True if the value is a function or spline, which a call can call.
[[nodiscard]] bool is_callable(const Value& value);

/// `F(1, 2, 3)`, `S(0.5)`, `S(0.5, cubic_spline)`: a number, or a vector of as many terms as `callee` yields.
[[nodiscard]] Value call_function(Context& context, const grammar::Call& call, const Value& callee);

/// `function { … }` as a pattern, or with a width and height as an image: a function of x, y and z, kept in the
/// database. None if its formula is not known, which is reported.
[[nodiscard]] scene::FunctionId make_point_function(Context& context, const grammar::Function& node);

}  // namespace isl::interpreter
