// The operators of expressions. Most of what a scene computes is numbers: they travel as plain doubles and become a
// Value only where something else is wanted.
#pragma once

#include "interpreter/context.h"

#include <optional>

namespace isl::interpreter {

/// Evaluates any expression. True: it is a number, in `number`; false: it is something else, in `other`.
[[nodiscard]] bool evaluate_scalar(Context& context, const grammar::Node& node, double& number,
                                   std::optional<Value>& other);

[[nodiscard]] Value evaluate_binary(Context& context, const grammar::Binary& node);
[[nodiscard]] Value evaluate_unary(Context& context, const grammar::Unary& node);
[[nodiscard]] Value evaluate_conditional(Context& context, const grammar::Conditional& node);
[[nodiscard]] Value evaluate_dot(Context& context, const grammar::Dot& node);

}  // namespace isl::interpreter
