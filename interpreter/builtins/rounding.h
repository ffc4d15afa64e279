// Tells numbers that only rounding made negative, such as 1 − V.x·V.x − V.y·V.y of a unit vector, from others.
#pragma once

#include "grammar/ast.h"
#include "interpreter/context.h"

namespace isl::interpreter {

/// True if the expression's value is negative and within rounding of zero: at most 2⁻⁴⁰ of the sum of the absolute
/// values of its terms. A sum of terms that each are the result of a few operations is off by some 2⁻⁵⁰ of that; 2⁻⁴⁰
/// leaves room for terms that have lost three digits themselves.
///
/// Evaluates the terms again, so it is false for expressions whose evaluation changes anything: those that call a
/// macro, or `rand`. A lone name is a term of its own, whose origin is not known.
[[nodiscard]] bool is_negative_by_rounding(Context& context, const grammar::Node& expression, double value);

}  // namespace isl::interpreter
