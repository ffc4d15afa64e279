#include "interpreter/operators.h"

#include "interpreter/arithmetic.h"
#include "interpreter/expressions.h"
#include "interpreter/nesting.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::BinaryOp;
using grammar::Node;
using grammar::NodeKind;
namespace word = grammar::word;

// ---- Items ----------------------------------------------------------------------------------------------------------

/// Which term an item is, by its word; kGray, and kNoItem for a word that is none.
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

[[nodiscard]] int term_of_item(grammar::Symbol item) {
  return grammar::is_reserved(item) ? kTermOfItem[static_cast<std::uint32_t>(item)] : kNoItem;
}

[[nodiscard]] [[gnu::noinline]] double item_of(Context& context, const grammar::Dot& node, const Value& base) {
  if (!base.is_numeric() || base.is_number()) {
    context.fail(node.span,
                 fmt::format("`.{}` needs a vector or colour, found {}", context.text(node.item), describe(base)));
  }
  const int i = term_of_item(node.item);
  // POV-Ray's weights.
  if (i == kGray) return 0.297 * base.term(0) + 0.589 * base.term(1) + 0.114 * base.term(2);
  if (i == kNoItem)
    context.fail(node.span, fmt::format("`.{}` is not an item of a vector or colour", context.text(node.item)));
  if (i >= base.term_count()) {
    context.fail(node.span, fmt::format("`.{}` does not exist in {}", context.text(node.item), describe(base)));
  }
  return base.terms()[i];
}

/// The value of a variable, where the node is one's name.
[[nodiscard]] const Value* variable(Context& context, const Node& node) {
  if (node.kind != NodeKind::name) return nullptr;
  const Slot* const slot = context.scopes.find(as<grammar::Name>(node).name);
  return slot && slot->value.is_numeric() ? &slot->value : nullptr;
}

// ---- Two operands ---------------------------------------------------------------------------------------------------

/// One side of an operator while the other is looked at. What a variable holds is read where it stands.
struct Side {
  double number = 0;
  std::optional<Value> kept;
  const Value* value = nullptr;  ///< null for a number

  [[nodiscard]] Operand operand() const {
    return value ? Operand{value->terms().data(), value->term_count()} : Operand{&number, 1};
  }
  [[nodiscard]] Value as_value() const { return value ? *value : Value(number); }
};

void evaluate_side(Context& context, const Node& node, Side& side) {
  if (is_at_hand(context, node, side.number)) return;
  side.value = variable(context, node);
  if (!side.value && !evaluate_scalar(context, node, side.number, side.kept)) side.value = &*side.kept;
}

/// Evaluating such a node runs nothing that could change a variable.
[[nodiscard]] bool is_still(const Node& node) {
  return node.kind == NodeKind::number || node.kind == NodeKind::name || node.kind == NodeKind::constant;
}

[[nodiscard]] Value compare_strings(Context& context, const grammar::Binary& node, const Value& left,
                                    const Value& right) {
  if (left.kind() == ValueKind::string && right.kind() == ValueKind::string && node.op <= BinaryOp::not_equal) {
    const int order = left.as<StringValue>().text.compare(right.as<StringValue>().text);
    return Value(compare(node.op, order, 0));
  }
  context.fail(node.op_span.empty() ? node.span : node.op_span,
               fmt::format("`{}` between {} and {}", spelling(node.op), describe(left), describe(right)));
}

/// A zero that promotion makes counts too: <1,2,3> / <1,1> divides by zero.
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

[[nodiscard]] [[gnu::noinline]] Value of_values(Context& context, const grammar::Binary& node, const Side& left,
                                                const Side& right) {
  const bool is_numeric = (!left.value || left.value->is_numeric()) && (!right.value || right.value->is_numeric());
  if (!is_numeric) [[unlikely]]
    return compare_strings(context, node, left.as_value(), right.as_value());
  if (node.op > BinaryOp::divide) [[unlikely]] {
    context.fail(left.value ? node.left->span : node.right->span,
                 fmt::format("`{}` compares numbers, found {}", spelling(node.op),
                             describe(left.value ? *left.value : *right.value)));
  }
  const Operand a = left.operand(), b = right.operand();
  if (node.op == BinaryOp::divide && has_zero(b, std::max(a.count, b.count))) warn_of_zero(context, node);
  return arithmetic(node.op, a, b);
}

/// The general case: any operand may be anything.
[[nodiscard]] [[gnu::noinline]] bool evaluate_sides(Context& context, const grammar::Binary& node, double& number,
                                                    std::optional<Value>& other) {
  Side left, right;
  if (is_still(*node.right)) {
    evaluate_side(context, *node.left, left);
  } else if (!evaluate_scalar(context, *node.left, left.number, left.kept)) {
    left.value = &*left.kept;
  }
  evaluate_side(context, *node.right, right);
  if (!left.value && !right.value) {
    number = of_numbers(context, node, left.number, right.number);
    return true;
  }
  other = of_values(context, node, left, right);
  if (!other->is_number()) return false;
  number = other->number();
  return true;
}

[[nodiscard]] [[gnu::noinline]] bool evaluate_binary(Context& context, const grammar::Binary& node, double& number,
                                                     std::optional<Value>& other) {
  double left = 0, right = 0;
  if (is_at_hand(context, *node.left, left) && is_at_hand(context, *node.right, right)) {
    number = of_numbers(context, node, left, right);
    return true;
  }
  const NestingGuard guard(context, node.span);
  return evaluate_sides(context, node, number, other);
}

// ---- One operand ----------------------------------------------------------------------------------------------------

[[nodiscard]] double applied(grammar::UnaryOp op, double operand) {
  switch (op) {
    case grammar::UnaryOp::plus: return operand;
    case grammar::UnaryOp::minus: return -operand;
    case grammar::UnaryOp::logical_not: return std::abs(operand) <= kTolerance ? 1 : 0;
  }
  ISL_CHECK(false, "operator {}", static_cast<int>(op));
}

[[gnu::noinline]] bool evaluate_unary(Context& context, const grammar::Unary& node, double& number,
                                      std::optional<Value>& other) {
  const NestingGuard guard(context, node.span);
  if (evaluate_scalar(context, *node.operand, number, other)) {
    number = applied(node.op, number);
    return true;
  }
  // What the parser makes of `(Name)`: the value itself, whatever it is, and no reference.
  const bool is_variable = node.operand->kind == NodeKind::name || node.operand->kind == NodeKind::index;
  if (node.op == grammar::UnaryOp::plus && is_variable) return false;
  if (!other->is_numeric()) {
    static constexpr std::string_view kSpellings[] = {"+", "-", "!"};
    context.fail(node.operand->span, fmt::format("`{}` needs a number or vector, found {}",
                                                 kSpellings[static_cast<int>(node.op)], describe(*other)));
  }
  Value::Terms terms = other->terms();
  for (int i = 0; i < other->term_count(); ++i) terms[i] = applied(node.op, terms[i]);
  other = Value(other->term_count(), terms);
  return false;
}

}  // namespace

bool is_item_at_hand(Context& context, const grammar::Dot& node, double& number) {
  const Value* const base = variable(context, *node.base);
  if (!base) return false;
  const int i = term_of_item(node.item);
  number = i >= 0 && i < base->term_count() && !base->is_number() ? base->terms()[i] : item_of(context, node, *base);
  return true;
}

bool evaluate_scalar(Context& context, const Node& node, double& number, std::optional<Value>& other) {
  if (is_at_hand(context, node, number)) return true;
  switch (node.kind) {
    case NodeKind::unary: return evaluate_unary(context, as<grammar::Unary>(node), number, other);
    case NodeKind::binary: return evaluate_binary(context, as<grammar::Binary>(node), number, other);
    default: break;
  }
  other = evaluate(context, node);
  if (!other->is_number()) return false;
  number = other->number();
  return true;
}

Value evaluate_binary(Context& context, const grammar::Binary& node) {
  double number = 0;
  std::optional<Value> other;
  if (evaluate_binary(context, node, number, other)) return Value(number);
  return *std::move(other);
}

[[gnu::noinline]] Value evaluate_dot(Context& context, const grammar::Dot& node) {
  const NestingGuard guard(context, node.span);
  double number = 0;
  if (is_item_at_hand(context, node, number)) return Value(number);
  return Value(item_of(context, node, evaluate(context, *node.base)));
}

Value evaluate_unary(Context& context, const grammar::Unary& node) {
  double number = 0;
  std::optional<Value> other;
  if (evaluate_unary(context, node, number, other)) return Value(number);
  return *std::move(other);
}

[[gnu::noinline]] Value evaluate_conditional(Context& context, const grammar::Conditional& node) {
  const NestingGuard guard(context, node.span);
  // Both arms, as in POV-Ray: an undeclared name in the arm not taken is an error too.
  const bool condition = evaluate_condition(context, *node.condition);
  Value yes = evaluate(context, *node.yes);
  Value no = evaluate(context, *node.no);
  return condition ? yes : no;
}

}  // namespace isl::interpreter
