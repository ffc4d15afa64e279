#include "interpreter/expressions.h"

#include "interpreter/arithmetic.h"
#include "interpreter/arrays.h"
#include "interpreter/builtins/builtins.h"
#include "interpreter/element_stream.h"
#include "interpreter/readers/rvalue.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::BinaryOp;
using grammar::Items;
using grammar::Node;
using grammar::NodeKind;
using grammar::Symbol;
namespace word = grammar::word;

// Each kind of composite expression has its own function, kept out of line: the recursion's stack frames stay small.

[[nodiscard]] [[gnu::noinline]] Value evaluate_name(Context& context, const grammar::Name& node) {
  Slot* const slot = context.scopes.find(node.name);
  if (!slot) {
    context.fail(node.span, fmt::format("undeclared identifier `{}`", context.text(node.name)),
                 context.suggest_declared(node.name));
  }
  if (slot->value.kind() <= ValueKind::poison) [[unlikely]] {
    if (slot->value.kind() == ValueKind::none) context.fail(node.span, "this array element is not set");
    throw Failed{};
  }
  if (slot->value.kind() == ValueKind::macro) [[unlikely]] {
    context.fail(node.span, fmt::format("macro `{}` is called with parentheses, even where it takes no arguments",
                                        context.text(node.name)));
  }
  return slot->value;
}

[[nodiscard]] [[gnu::noinline]] Value evaluate_constant(Context& context, const grammar::Constant& node) {
  switch (static_cast<word::Index>(node.word)) {
    case word::kIndex_x: return {3, {1, 0, 0}};
    case word::kIndex_y: return {3, {0, 1, 0}};
    case word::kIndex_z: return {3, {0, 0, 1}};
    case word::kIndex_u: return {2, {1, 0}};
    case word::kIndex_v: return {2, {0, 1}};
    case word::kIndex_t: return {4, {0, 0, 0, 1}};
    case word::kIndex_pi: return Value(std::numbers::pi);
    case word::kIndex_yes:
    case word::kIndex_on:
    case word::kIndex_true: return Value(1.0);
    case word::kIndex_no:
    case word::kIndex_off:
    case word::kIndex_false: return Value(0.0);
    case word::kIndex_clock: return Value(context.options.clock);
    case word::kIndex_clock_on: return Value(context.options.frame > 0 ? 1.0 : 0.0);
    case word::kIndex_version: return Value(context.language_version);
    default: context.fail(node.span, fmt::format("`{}` is not supported", context.text(node.word)));
  }
}

/// Evaluates one coordinate; a macro or directive may yield several, separated by commas.
template <class Append>
void evaluate_coordinate(Context& context, const Node& node, Append append) {
  const bool is_single = node.kind < NodeKind::word && node.kind != NodeKind::call;
  if (is_single) return append(evaluate_number(context, node));
  const Node* const items[] = {&node};
  ElementStream stream(context, Items(items), node.span);
  while (!stream.peek().is(ElementKind::end)) {
    const Value value = read_rvalue(stream);
    if (!value.is_number())
      context.fail(node.span, fmt::format("a coordinate must be a number, found {}", describe(value)));
    append(value.number());
    if (!stream.accept_comma()) stream.accept(ElementKind::semicolon);
  }
}

[[nodiscard]] [[gnu::noinline]] Value evaluate_vector(Context& context, const grammar::Vector& node) {
  const NestingGuard guard(context, node.span);
  Value::Terms terms{};
  int count = 0;
  for (const Node* coordinate : node.coordinates) {
    evaluate_coordinate(context, *coordinate, [&](double number) {
      if (count == Value::kMaxTerms) context.fail(node.span, "a vector has at most 5 coordinates");
      terms[count++] = number;
    });
  }
  if (count < 2) context.fail(node.span, fmt::format("a vector needs at least 2 coordinates, found {}", count));
  return {count, terms};
}

[[nodiscard]] Value item_of(Context& context, const grammar::Dot& node, const Value& base) {
  if (!base.is_numeric() || base.is_number()) {
    context.fail(node.span,
                 fmt::format("`.{}` needs a vector or colour, found {}", context.text(node.item), describe(base)));
  }
  int i = -1;
  switch (static_cast<word::Index>(node.item)) {
    case word::kIndex_x:
    case word::kIndex_u:
    case word::kIndex_red: i = 0; break;
    case word::kIndex_y:
    case word::kIndex_v:
    case word::kIndex_green: i = 1; break;
    case word::kIndex_z:
    case word::kIndex_blue: i = 2; break;
    case word::kIndex_t:
    case word::kIndex_filter: i = 3; break;
    case word::kIndex_transmit: i = 4; break;
    // POV-Ray's weights.
    case word::kIndex_gray: return Value(0.297 * base.terms()[0] + 0.589 * base.terms()[1] + 0.114 * base.terms()[2]);
    default: break;
  }
  if (i < 0)
    context.fail(node.span, fmt::format("`.{}` is not an item of a vector or colour", context.text(node.item)));
  if (i >= base.term_count()) {
    context.fail(node.span, fmt::format("`.{}` does not exist in {}", context.text(node.item), describe(base)));
  }
  return Value(base.terms()[i]);
}

[[nodiscard]] [[gnu::noinline]] Value evaluate_dot(Context& context, const grammar::Dot& node) {
  const NestingGuard guard(context, node.span);
  if (node.base->kind == NodeKind::name) {  // without a copy
    const Slot* const slot = context.scopes.find(as<grammar::Name>(*node.base).name);
    if (slot && slot->value.is_numeric()) return item_of(context, node, slot->value);
  }
  return item_of(context, node, evaluate(context, *node.base));
}

[[nodiscard]] [[gnu::noinline]] Value evaluate_unary(Context& context, const grammar::Unary& node) {
  const NestingGuard guard(context, node.span);
  Value operand = evaluate(context, *node.operand);
  // What the parser makes of `(Name)`: the value itself, whatever it is, and no reference.
  const bool is_variable = node.operand->kind == NodeKind::name || node.operand->kind == NodeKind::index;
  if (node.op == grammar::UnaryOp::plus && is_variable) return operand;
  if (!operand.is_numeric()) {
    static constexpr std::string_view kSpellings[] = {"+", "-", "!"};
    context.fail(node.operand->span, fmt::format("`{}` needs a number or vector, found {}",
                                                 kSpellings[static_cast<int>(node.op)], describe(operand)));
  }
  Value::Terms terms = operand.terms();
  for (int i = 0; i < operand.term_count(); ++i) {
    if (node.op == grammar::UnaryOp::minus) terms[i] = -terms[i];
    if (node.op == grammar::UnaryOp::logical_not) terms[i] = std::abs(terms[i]) <= kTolerance ? 1 : 0;
  }
  return {operand.term_count(), terms};
}

Value compare_strings(Context& context, const grammar::Binary& node, const Value& left, const Value& right) {
  if (left.kind() == ValueKind::string && right.kind() == ValueKind::string && node.op <= BinaryOp::not_equal) {
    const int order = left.as<StringValue>().text.compare(right.as<StringValue>().text);
    return Value(compare(node.op, order, 0));
  }
  context.fail(node.op_span.empty() ? node.span : node.op_span,
               fmt::format("`{}` between {} and {}", spelling(node.op), describe(left), describe(right)));
}

[[gnu::noinline]] void warn_of_zero(Context& context, const grammar::Binary& node, const Value& divisor, int count) {
  // A zero that promotion makes counts too: <1,2,3> / <1,1> divides by zero.
  for (int i = 0; i < count; ++i) {
    const double term = divisor.is_number() ? divisor.number() : divisor.terms()[i];
    if (term == 0) return context.warn(node.op_span.empty() ? node.span : node.op_span, "division by zero");
  }
}

[[nodiscard]] [[gnu::noinline]] Value evaluate_binary(Context& context, const grammar::Binary& node) {
  const NestingGuard guard(context, node.span);
  const Value left = evaluate(context, *node.left);
  const Value right = evaluate(context, *node.right);
  if (left.is_number() && right.is_number()) {
    const double a = left.number(), b = right.number();
    switch (node.op) {
      case BinaryOp::add: return Value(a + b);
      case BinaryOp::subtract: return Value(a - b);
      case BinaryOp::multiply: return Value(a * b);
      case BinaryOp::divide:
        if (b == 0) [[unlikely]]
          warn_of_zero(context, node, right, 1);
        return Value(a / b);
      default: return Value(compare(node.op, a, b));
    }
  }
  if (!left.is_numeric() || !right.is_numeric()) [[unlikely]]
    return compare_strings(context, node, left, right);
  if (node.op > BinaryOp::divide) [[unlikely]] {
    const bool left_is_vector = !left.is_number();
    context.fail(
        left_is_vector ? node.left->span : node.right->span,
        fmt::format("`{}` compares numbers, found {}", spelling(node.op), describe(left_is_vector ? left : right)));
  }
  if (node.op == BinaryOp::divide) warn_of_zero(context, node, right, std::max(left.term_count(), right.term_count()));
  return arithmetic(node.op, left, right);
}

[[nodiscard]] [[gnu::noinline]] Value evaluate_conditional(Context& context, const grammar::Conditional& node) {
  const NestingGuard guard(context, node.span);
  // Both arms, as in POV-Ray: an undeclared name in the arm not taken is an error too.
  const bool condition = evaluate_condition(context, *node.condition);
  Value yes = evaluate(context, *node.yes);
  Value no = evaluate(context, *node.no);
  return condition ? yes : no;
}

[[nodiscard]] Value value_of_element(Context& context, const Node& node) {
  const Slot& slot = find_slot(context, node);
  if (slot.value.kind() == ValueKind::none) context.fail(node.span, "this array element is not set");
  if (slot.value.kind() == ValueKind::poison) throw Failed{};
  return slot.value;
}

}  // namespace

Value evaluate(Context& context, const Node& node) {
  switch (node.kind) {
    case NodeKind::number: return Value(as<grammar::Number>(node).value);
    case NodeKind::string: return make_string(context, std::string(as<grammar::String>(node).text), node.span);
    case NodeKind::constant: return evaluate_constant(context, as<grammar::Constant>(node));
    case NodeKind::name: return evaluate_name(context, as<grammar::Name>(node));
    case NodeKind::index: return value_of_element(context, node);
    case NodeKind::call: return evaluate_call(context, as<grammar::Call>(node));
    case NodeKind::function_call: return call_builtin(context, as<grammar::FunctionCall>(node));
    case NodeKind::dot: return evaluate_dot(context, as<grammar::Dot>(node));
    case NodeKind::vector: return evaluate_vector(context, as<grammar::Vector>(node));
    case NodeKind::unary: return evaluate_unary(context, as<grammar::Unary>(node));
    case NodeKind::binary: return evaluate_binary(context, as<grammar::Binary>(node));
    case NodeKind::conditional: return evaluate_conditional(context, as<grammar::Conditional>(node));
    case NodeKind::array: return make_array(context, as<grammar::Array>(node));
    case NodeKind::function: context.unsupported(node.span, "function"); throw Failed{};
    case NodeKind::error: context.report_unparsed(as<grammar::Error>(node)); throw Failed{};
    default: {
      const Node* const items[] = {&node};
      return evaluate_items(context, Items(items), node.span);
    }
  }
}

std::vector<double> evaluate_coordinates(Context& context, const grammar::Vector& node) {
  std::vector<double> numbers;
  for (const Node* coordinate : node.coordinates) {
    evaluate_coordinate(context, *coordinate, [&](double number) { numbers.push_back(number); });
  }
  return numbers;
}

double evaluate_number(Context& context, const Node& node) {
  if (node.kind == NodeKind::number) return as<grammar::Number>(node).value;
  if (node.kind == NodeKind::name) {
    const Slot* const slot = context.scopes.find(as<grammar::Name>(node).name);
    if (slot && slot->value.is_number()) return slot->value.number();
  }
  const Value value = evaluate(context, node);
  if (!value.is_number()) context.fail(node.span, fmt::format("expected a number, found {}", describe(value)));
  return value.number();
}

bool evaluate_condition(Context& context, const Node& node) {
  return std::abs(evaluate_number(context, node)) > kTolerance;
}

const StringValue& evaluate_string(Context& context, const Node& node, Value& keep) {
  keep = evaluate(context, node);
  if (keep.kind() != ValueKind::string)
    context.fail(node.span, fmt::format("expected a string, found {}", describe(keep)));
  return keep.as<StringValue>();
}

Value make_string(Context& context, std::string text, SourceSpan span) {
  context.check_memory(span, text.size());
  return {ValueKind::string, make_shared_value<StringValue>(std::move(text), context.memory)};
}

Slot* find_slot_if_declared(Context& context, const Node& target) {
  if (target.kind == NodeKind::name) return context.scopes.find(as<grammar::Name>(target).name);
  if (target.kind == NodeKind::index)
    return find_element(context, as<grammar::Index>(target), /*may_be_undeclared=*/true);
  throw Failed{};  // an error node: it was reported
}

Slot& find_slot(Context& context, const Node& target) {
  if (target.kind == NodeKind::index)
    return *find_element(context, as<grammar::Index>(target), /*may_be_undeclared=*/false);
  if (target.kind != NodeKind::name) throw Failed{};
  const Symbol name = as<grammar::Name>(target).name;
  if (Slot* slot = context.scopes.find(name)) return *slot;
  context.fail(target.span, fmt::format("undeclared identifier `{}`", context.text(name)),
               context.suggest_declared(name));
}

// ---- Macro calls and directives as values ---------------------------------------------------------------------------

namespace {

Value read_only_value(ElementStream& stream) {
  Value value = read_rvalue(stream);
  stream.accept(ElementKind::semicolon);
  const Element& next = stream.peek();
  if (!next.is(ElementKind::end)) stream.context().fail(next.span, "one value is expected here, and this is a second");
  return value;
}

}  // namespace

[[gnu::noinline]] Value evaluate_call(Context& context, const grammar::Call& call) {
  ElementStream stream(context, call, *called_macro(context, call));
  if (stream.peek().is(ElementKind::end)) context.fail(call.span, "this macro call yields no value");
  return read_only_value(stream);
}

[[gnu::noinline]] Value evaluate_items(Context& context, Items items, SourceSpan span) {
  ElementStream stream(context, items, span);
  if (stream.peek().is(ElementKind::end)) context.fail(span, "a value is expected here, and there is none");
  return read_only_value(stream);
}

}  // namespace isl::interpreter
