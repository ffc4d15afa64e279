#include "interpreter/operators.h"

#include "interpreter/arithmetic.h"
#include "interpreter/expressions.h"
#include "interpreter/nesting.h"
#include "interpreter/places.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::BinaryOp;
using grammar::Node;
using grammar::NodeKind;
namespace word = grammar::word;

// ---- Items ----------------------------------------------------------------------------------------------------------

/// The term that an item's word names; kGray, and kNoItem for any other word.
constexpr std::int8_t kNoItem = -1, kGray = -2;
constexpr std::array<std::int8_t, word::kReservedCount> kTermOfItem = [] {
  std::array<std::int8_t, word::kReservedCount> terms{};
  terms.fill(kNoItem);
  terms[word::kIndex_x] = terms[word::kIndex_u] = terms[word::kIndex_red] = 0;
  terms[word::kIndex_y] = terms[word::kIndex_v] = terms[word::kIndex_green] = 1;
  terms[word::kIndex_z] = terms[word::kIndex_blue] = 2;
  terms[word::kIndex_t] = terms[word::kIndex_filter] = 3;
  terms[word::kIndex_transmit] = 4;
  terms[word::kIndex_gray] = kGray;
  return terms;
}();

[[nodiscard]] [[gnu::noinline]] double item_of(Context& context, const grammar::Dot& node, const Value& base) {
  if (!base.is_numeric() || base.is_number()) {
    context.fail(node.span,
                 fmt::format("`.{}` needs a vector or colour, found {}", context.text(node.item), describe(base)));
  }
  const int i = term_of_item(node.item);
  // POV-Ray's weights.
  if (i == kGray) return 0.297 * base.term(0) + 0.589 * base.term(1) + 0.114 * base.term(2);
  if (i == kNoItem)
    context.fail(node.span, fmt::format("`.{}` is not an item of a vector or colour", context.text(node.item)),
                 "the items are `x y z u v t red green blue filter transmit gray`, one at a time");
  if (i >= base.term_count()) {
    context.fail(node.span, fmt::format("`.{}` does not exist in {}", context.text(node.item), describe(base)));
  }
  return base.terms()[i];
}

/// The value of a key in a dictionary.
[[nodiscard]] [[gnu::noinline]] Value field_of(Context& context, const grammar::Dot& node, const Value& base) {
  const Slot& slot = find_field(context, node, base);
  if (slot.value.kind() == ValueKind::poison) throw Failed{};
  if (slot.value.kind() == ValueKind::none)
    context.fail(node.span, fmt::format("`.{}` has no value", context.text(node.item)));
  return slot.value;
}

/// The value of a variable, if the node is the name of one.
[[nodiscard]] const Value* variable(Context& context, const Node& node) {
  if (node.kind != NodeKind::name) return nullptr;
  const Slot* const slot = context.scopes.find(as<grammar::Name>(node).name);
  return slot && slot->value.is_numeric() ? &slot->value : nullptr;
}

/// The general case: an item of any expression, and mistakes.
[[gnu::noinline]] void evaluate_item(Context& context, const grammar::Dot& node, Value& result) {
  const NestingGuard guard(context, node.span);
  const Value* base = variable(context, *node.base);
  if (!base) {
    evaluate_into(context, *node.base, result);
    base = &result;
  }
  if (base->kind() == ValueKind::dictionary) {
    result = field_of(context, node, *base);
    return;
  }
  result.set_number(item_of(context, node, *base));
}

// ---- Two operands ---------------------------------------------------------------------------------------------------

/// True if evaluating the node runs nothing that could change a variable.
[[nodiscard]] bool is_still(const Node& node) {
  return node.kind == NodeKind::number || node.kind == NodeKind::name || node.kind == NodeKind::constant;
}

/// The remedy for an operator that joins strings in other languages.
[[nodiscard]] std::string hint_for_strings(BinaryOp op, const Value& left, const Value& right) {
  if (op != BinaryOp::add) return {};
  const auto is_string = [](const Value& value) { return value.kind() == ValueKind::string; };
  if (is_string(left) && is_string(right)) return "`concat(a, b)` joins strings";
  if (is_string(left) && right.is_number()) return "`concat(a, str(b, 0, -1))` joins a string and a number";
  if (left.is_number() && is_string(right)) return "`concat(str(a, 0, -1), b)` joins a number and a string";
  if (is_string(left) && right.is_numeric())
    return "`concat(a, vstr(3, b, \", \", 0, -1))` joins a string and a vector";
  return {};
}

[[nodiscard]] bool is_comparison(BinaryOp op) { return op >= BinaryOp::less && op <= BinaryOp::not_equal; }

[[nodiscard]] bool is_sign(BinaryOp op) { return op == BinaryOp::add || op == BinaryOp::subtract; }

/// True if the operator is the sign of an argument that has no comma before it (TermsApart).
[[nodiscard]] bool may_be_apart(const Context& context, const grammar::Binary& node, const Value& left,
                                const Value& right) {
  if (!is_sign(node.op) || left.is_numeric() || left.kind() == ValueKind::string || !right.is_numeric()) return false;
  const Node* term = context.argument;
  while (term != nullptr && term != &node) {
    const bool is_sum = term->kind == NodeKind::binary && is_sign(as<grammar::Binary>(*term).op);
    term = is_sum ? as<grammar::Binary>(*term).left : nullptr;
  }
  return term != nullptr;
}

/// The only operation on operands that are not both numeric is the comparison of two strings.
[[nodiscard]] Value compare_strings(Context& context, const grammar::Binary& node, const Value& left,
                                    const Value& right) {
  if (may_be_apart(context, node, left, right)) throw TermsApart{&node, left, right};
  if (is_comparison(node.op) && left.kind() == ValueKind::string && right.kind() == ValueKind::string) {
    const int order = left.as<StringValue>().text.compare(right.as<StringValue>().text);
    return Value(compare(node.op, order, 0));
  }
  context.fail(node.op_span.empty() ? node.span : node.op_span,
               fmt::format("`{}` cannot combine {} and {}", spelling(node.op), describe(left), describe(right)),
               hint_for_strings(node.op, left, right));
}

/// A zero from promotion counts too: <1,2,3> / <1,1> divides by zero.
[[nodiscard]] bool has_zero(const Operand& divisor, int count) {
  for (int i = 0; i < count; ++i) {
    if (divisor[i] == 0) return true;
  }
  return false;
}

[[gnu::noinline]] void warn_of_zero(Context& context, const grammar::Binary& node) {
  context.warn(node.op_span.empty() ? node.span : node.op_span, "division by zero");
}

[[nodiscard]] inline double of_numbers(Context& context, const grammar::Binary& node, double a, double b) {
  switch (node.op) {
    case BinaryOp::add: return a + b;
    case BinaryOp::subtract: return a - b;
    case BinaryOp::multiply: return a * b;
    case BinaryOp::divide:
      if (b == 0) [[unlikely]]
        warn_of_zero(context, node);
      return quotient(a, b);
    default: return compare(node.op, a, b);
  }
}

[[nodiscard]] [[gnu::noinline]] Value of_values(Context& context, const grammar::Binary& node, const Value& left,
                                                const Value& right) {
  if (!left.is_numeric() || !right.is_numeric()) [[unlikely]]
    return compare_strings(context, node, left, right);
  if (node.op > BinaryOp::divide) [[unlikely]] {
    const bool is_left = !left.is_number();
    context.fail(is_left ? node.left->span : node.right->span,
                 fmt::format("`{}` compares numbers, found {}", spelling(node.op), describe(is_left ? left : right)));
  }
  const Operand a{left.terms().data(), left.term_count()}, b{right.terms().data(), right.term_count()};
  if (node.op == BinaryOp::divide && has_zero(b, std::max(a.count, b.count))) warn_of_zero(context, node);
  return arithmetic(node.op, a, b);
}

/// The general case: operands of any kind.
[[gnu::noinline]] void evaluate_sides(Context& context, const grammar::Binary& node, Value& result) {
  if (const std::optional<double> order = compare_texts(context, node)) return result.set_number(*order);
  const NestingGuard guard(context, node.span);
  const Value* left = is_still(*node.right) ? variable(context, *node.left) : nullptr;
  if (!left) {
    evaluate_into(context, *node.left, result);
    left = &result;
  }
  Value kept;
  const Value* right = variable(context, *node.right);
  if (!right) {
    evaluate_into(context, *node.right, kept);
    right = &kept;
  }
  if (left->is_number() && right->is_number()) {
    result.set_number(of_numbers(context, node, left->number(), right->number()));
  } else {
    result = of_values(context, node, *left, *right);
  }
}

}  // namespace

Value rest_of_terms(Context& context, const Node& sum, const TermsApart& apart) {
  const auto& node = as<grammar::Binary>(sum);
  if (&node == apart.node)
    return node.op == BinaryOp::add ? apart.right : of_values(context, node, Value(0.0), apart.right);
  const Value left = rest_of_terms(context, *node.left, apart);
  return of_values(context, node, left, evaluate(context, *node.right));
}

int term_of_item(grammar::Symbol item) {
  if (grammar::is_reserved(item)) return kTermOfItem[static_cast<std::uint32_t>(item)];
  return item == grammar::newer_word::kw_grey ? kGray : kNoItem;
}

std::optional<std::string_view> text_at_hand(Context& context, const Node& node) {
  if (node.kind == NodeKind::string) return as<grammar::String>(node).text;
  const Slot* const slot = node.kind == NodeKind::name ? context.scopes.find(as<grammar::Name>(node).name) : nullptr;
  if (!slot || slot->value.kind() != ValueKind::string) return {};
  return slot->value.as<StringValue>().text;
}

std::optional<double> compare_texts(Context& context, const grammar::Binary& node) {
  if (!is_comparison(node.op)) return {};
  const std::optional<std::string_view> left = text_at_hand(context, *node.left);
  const std::optional<std::string_view> right = left ? text_at_hand(context, *node.right) : std::nullopt;
  if (!right) return {};
  return compare(node.op, left->compare(*right), 0);
}

const double* item_at_hand(Context& context, const grammar::Dot& node) {
  const Value* const base = variable(context, *node.base);
  if (!base || base->is_number()) return nullptr;
  const int i = term_of_item(node.item);
  return i >= 0 && i < base->term_count() ? &base->terms()[i] : nullptr;
}

[[gnu::noinline]] void evaluate_binary(Context& context, const grammar::Binary& node, Value& result) {
  if (const double* const left = number_at_hand(context, *node.left)) {
    if (const double* const right = number_at_hand(context, *node.right))
      return result.set_number(of_numbers(context, node, *left, *right));
  }
  evaluate_sides(context, node, result);
}

[[gnu::noinline]] void evaluate_dot(Context& context, const grammar::Dot& node, Value& result) {
  if (const double* const item = item_at_hand(context, node)) return result.set_number(*item);
  evaluate_item(context, node, result);
}

[[gnu::noinline]] void evaluate_unary(Context& context, const grammar::Unary& node, Value& result) {
  const NestingGuard guard(context, node.span);
  evaluate_into(context, *node.operand, result);
  if (result.is_number()) return result.set_number(applied(node.op, result.number()));
  // The parser's form of `(Name)`: the value itself, of any kind, and no reference.
  if (node.op == grammar::UnaryOp::plus && grammar::is_place(*node.operand)) return;
  if (!result.is_numeric()) {
    static constexpr std::string_view kSpellings[] = {"+", "-", "!"};
    context.fail(node.operand->span, fmt::format("`{}` needs a number or vector, found {}",
                                                 kSpellings[static_cast<int>(node.op)], describe(result)));
  }
  Value::Terms terms = result.terms();
  for (int i = 0; i < result.term_count(); ++i) terms[i] = applied(node.op, terms[i]);
  result = Value(result.term_count(), terms);
}

[[gnu::noinline]] void evaluate_conditional(Context& context, const grammar::Conditional& node, Value& result) {
  const NestingGuard guard(context, node.span);
  // Both arms are evaluated, as in POV-Ray: an undeclared name in the arm not taken is an error too.
  const bool condition = evaluate_condition(context, *node.condition);
  Value no;
  evaluate_into(context, *node.yes, result);
  evaluate_into(context, *node.no, no);
  if (!condition) result = std::move(no);
}

}  // namespace isl::interpreter
