// The operators of expressions. Operands that need no evaluation are read in place; all others are evaluated into a
// place that the caller has, so that a value is never copied on its way up the tree.
#pragma once

#include "interpreter/context.h"

#include <optional>
#include <string_view>

namespace isl::interpreter {

/// The index of the term that an item's word names; negative for `gray` and for a word that names none.
[[nodiscard]] int term_of_item(grammar::Symbol item);

/// The text of a literal, or of a variable that holds a string; none for all others. Valid until the next evaluation.
[[nodiscard]] std::optional<std::string_view> text_at_hand(Context& context, const grammar::Node& node);
/// The result of a comparison of strings that need no evaluation; none if it is no such comparison.
[[nodiscard]] std::optional<double> compare_texts(Context& context, const grammar::Binary& node);

/// `Variable.x` if the variable holds a vector that has such an item, else null.
[[nodiscard]] const double* item_at_hand(Context& context, const grammar::Dot& node);

/// The number of a literal, or of a named variable or item: most operands are one of these. Null for all others. Valid
/// until the next evaluation.
[[nodiscard]] inline const double* number_at_hand(Context& context, const grammar::Node& node) {
  using grammar::NodeKind;
  if (node.kind == NodeKind::name) {
    const Slot* const slot = context.scopes.find(grammar::as<grammar::Name>(node).name);
    return slot && slot->value.is_number() ? slot->value.terms().data() : nullptr;
  }
  if (node.kind == NodeKind::number) return &grammar::as<grammar::Number>(node).value;
  if (node.kind == NodeKind::dot) return item_at_hand(context, grammar::as<grammar::Dot>(node));
  return node.kind == NodeKind::unary ? grammar::as<grammar::Unary>(node).negative : nullptr;
}

/// Thrown where the terms of a macro call's argument (Context::argument) are two arguments without a comma between
/// them, as in `Move(Shape() -y)`: the value left of a sign is an object, or another value that has no sum. The
/// operands of `node` are evaluated.
struct TermsApart {
  const grammar::Binary* node;
  Value left, right;
};
/// The second of the two arguments: all of the sum that begins with the sign.
[[nodiscard]] Value rest_of_terms(Context& context, const grammar::Node& sum, const TermsApart& apart);

// Each is evaluate_into() for one kind of node.
void evaluate_binary(Context& context, const grammar::Binary& node, Value& result);
void evaluate_unary(Context& context, const grammar::Unary& node, Value& result);
void evaluate_conditional(Context& context, const grammar::Conditional& node, Value& result);
void evaluate_dot(Context& context, const grammar::Dot& node, Value& result);

}  // namespace isl::interpreter
