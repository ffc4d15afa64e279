// The operators of expressions. Most of what a scene computes is numbers: they travel as plain doubles and become a
// Value only where something else is wanted.
#pragma once

#include "interpreter/context.h"

#include <optional>

namespace isl::interpreter {

/// Evaluates any expression. True: it is a number, in `number`; false: it is something else, in `other`.
[[nodiscard]] bool evaluate_scalar(Context& context, const grammar::Node& node, double& number,
                                   std::optional<Value>& other);

/// `Variable.x` where the variable holds a vector: an item that can be had without copying it. Fails where the vector
/// has no such item.
[[nodiscard]] bool is_item_at_hand(Context& context, const grammar::Dot& node, double& number);

/// Whether a number stands there, or in the variable that is named there: what most operands are.
[[nodiscard]] inline bool is_at_hand(Context& context, const grammar::Node& node, double& number) {
  using grammar::NodeKind;
  if (node.kind == NodeKind::name) {
    const Slot* const slot = context.scopes.find(grammar::as<grammar::Name>(node).name);
    if (!slot || !slot->value.is_number()) return false;
    number = slot->value.number();
    return true;
  }
  if (node.kind == NodeKind::number) {
    number = grammar::as<grammar::Number>(node).value;
    return true;
  }
  return node.kind == NodeKind::dot && is_item_at_hand(context, grammar::as<grammar::Dot>(node), number);
}

[[nodiscard]] Value evaluate_binary(Context& context, const grammar::Binary& node);
[[nodiscard]] Value evaluate_unary(Context& context, const grammar::Unary& node);
[[nodiscard]] Value evaluate_conditional(Context& context, const grammar::Conditional& node);
[[nodiscard]] Value evaluate_dot(Context& context, const grammar::Dot& node);

}  // namespace isl::interpreter
