// The operators of expressions. Most of what a scene computes is numbers: they travel as plain doubles and become a
// Value only where something else is wanted.
#pragma once

#include "interpreter/context.h"

#include <optional>

namespace isl::interpreter {

/// Evaluates any expression. True: it is a number, in `number`; false: it is something else, in `other`.
[[nodiscard]] bool evaluate_scalar(Context& context, const grammar::Node& node, double& number,
                                   std::optional<Value>& other);

/// Whether a number stands there, or in the variable that is named there: what most operands are.
[[nodiscard]] inline bool is_at_hand(const Context& context, const grammar::Node& node, double& number) {
  if (node.kind == grammar::NodeKind::name) {
    const Slot* const slot = context.scopes.find(grammar::as<grammar::Name>(node).name);
    if (!slot || !slot->value.is_number()) return false;
    number = slot->value.number();
    return true;
  }
  if (node.kind != grammar::NodeKind::number) return false;
  number = grammar::as<grammar::Number>(node).value;
  return true;
}

[[nodiscard]] Value evaluate_binary(Context& context, const grammar::Binary& node);
[[nodiscard]] Value evaluate_unary(Context& context, const grammar::Unary& node);
[[nodiscard]] Value evaluate_conditional(Context& context, const grammar::Conditional& node);
[[nodiscard]] Value evaluate_dot(Context& context, const grammar::Dot& node);

}  // namespace isl::interpreter
