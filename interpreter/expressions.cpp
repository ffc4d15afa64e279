#include "interpreter/expressions.h"

#include "interpreter/arrays.h"
#include "interpreter/builtins/builtins.h"
#include "interpreter/deprecated_names.h"
#include "interpreter/dictionaries.h"
#include "interpreter/element_stream.h"
#include "interpreter/functions/functions.h"
#include "interpreter/macro_calls.h"
#include "interpreter/newer_words.h"
#include "interpreter/operators.h"
#include "interpreter/places.h"
#include "interpreter/readers/words/rvalue.h"
#include "interpreter/routines/routines.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Items;
using grammar::Node;
using grammar::NodeKind;
using grammar::Symbol;
namespace word = grammar::word;

// Each kind of composite expression has its own function, kept out of line: the recursion's stack frames stay small.

/// The value of a name that is neither a number nor a vector.
[[gnu::noinline]] void evaluate_other_name(Context& context, const grammar::Name& node, const Slot* slot,
                                           Value& result) {
  if (!slot && is_newer_value(node.name)) {
    result = newer_value(context, node.name, node.span);
    return;
  }
  if (!slot) fail_undeclared(context, node.span, node.name);
  if (slot->value.kind() == ValueKind::deprecated) [[unlikely]]
    slot = &use_deprecated(context, *slot, node.span);
  if (slot->value.kind() <= ValueKind::poison) [[unlikely]] {
    if (slot->value.kind() == ValueKind::none)
      context.fail(node.span,
                   fmt::format("`{}` has no value: an array element that is not set, or a file that is closed",
                               context.text(node.name)));
    throw Failed{};
  }
  if (slot->value.kind() == ValueKind::macro) [[unlikely]] {
    context.fail(node.span,
                 fmt::format("expected parentheses after macro `{}`; a macro without arguments needs them too",
                             context.text(node.name)));
  }
  result = slot->value;
}

void evaluate_name(Context& context, const grammar::Name& node, Value& result) {
  const Slot* const slot = context.scopes.find(node.name);
  if (!slot || !slot->value.is_numeric()) [[unlikely]]
    return evaluate_other_name(context, node, slot, result);
  result = slot->value;
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
    case word::kIndex_now: return Value(days_since_2000());
    case word::kIndex_clock_on: return Value(context.options.clock_on ? 1.0 : 0.0);
    case word::kIndex_version: return Value(context.version.number());
    default: context.fail(node.span, fmt::format("`{}` is not supported", context.text(node.word)));
  }
}

/// Evaluates a macro call or directive among the coordinates, together with the semicolons that end it; it may yield
/// none or several.
template <class Append>
[[gnu::noinline]] void follow_coordinates(Context& context, Items items, Append append) {
  const Node& node = *items[0];
  ElementStream stream(context, items, node.span);
  while (!stream.peek().is(ElementKind::end)) {
    const Value value = read_rvalue(stream);
    if (!value.is_number())
      context.fail(node.span, fmt::format("a coordinate must be a number, found {}", describe(value)));
    append(value.number());
    if (!stream.accept_comma()) stream.accept(ElementKind::semicolon);
  }
}

/// Evaluates the coordinates of a vector in turn.
template <class Append>
void evaluate_each_coordinate(Context& context, Items coordinates, Append append) {
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const Node& node = *coordinates[i];
    const bool is_single = node.kind < NodeKind::word && node.kind != NodeKind::call;
    if (is_single) {
      append(evaluate_number(context, node));
      continue;
    }
    std::size_t end = i + 1;
    while (end < coordinates.size() && coordinates[end]->kind == NodeKind::semicolon) ++end;
    follow_coordinates(context, coordinates.subspan(i, end - i), append);
    i = end - 1;
  }
}

[[gnu::noinline]] void evaluate_vector(Context& context, const grammar::Vector& node, Value& result) {
  const NestingGuard guard(context, node.span);
  Value::Terms terms{};
  int count = 0;
  evaluate_each_coordinate(context, node.coordinates, [&](double number) {
    if (count == Value::kMaxTerms) context.fail(node.span, "a vector has at most 5 coordinates");
    terms[count++] = number;
  });
  if (count < 2) context.fail(node.span, fmt::format("a vector needs at least 2 coordinates, found {}", count));
  result = Value(count, terms);
}

/// Evaluates the nodes that are rare, or that take long.
[[nodiscard]] [[gnu::noinline]] Value evaluate_rare(Context& context, const Node& node) {
  switch (node.kind) {
    case NodeKind::string: return make_string(context, std::string(as<grammar::String>(node).text), node.span);
    case NodeKind::constant: return evaluate_constant(context, as<grammar::Constant>(node));
    case NodeKind::array: return make_array(context, as<grammar::Array>(node));
    case NodeKind::function: return make_function(context, as<grammar::Function>(node));
    case NodeKind::dictionary: return make_dictionary(context, as<grammar::Dictionary>(node));
    case NodeKind::tuple:
      context.fail(node.span, "a tuple of values can only be declared as one: `#declare (A, B) = (1, 2);`");
    case NodeKind::error: context.meet(as<grammar::Error>(node)); throw Failed{};
    default: {
      const Node* const items[] = {&node};
      return evaluate_items(context, Items(items), node.span);
    }
  }
}

[[gnu::noinline]] void evaluate_rare_into(Context& context, const Node& node, Value& result) {
  result = evaluate_rare(context, node);
}

}  // namespace

void evaluate_into(Context& context, const Node& node, Value& result) {
  switch (node.kind) {
    case NodeKind::number: return result.set_number(as<grammar::Number>(node).value);
    case NodeKind::name: return evaluate_name(context, as<grammar::Name>(node), result);
    case NodeKind::index:
    case NodeKind::scoped_name: return read_place(context, node, result);
    case NodeKind::function_call: return call_builtin(context, as<grammar::FunctionCall>(node), result);
    case NodeKind::dot: return evaluate_dot(context, as<grammar::Dot>(node), result);
    case NodeKind::vector: return evaluate_vector(context, as<grammar::Vector>(node), result);
    case NodeKind::unary: return evaluate_unary(context, as<grammar::Unary>(node), result);
    case NodeKind::binary: return evaluate_binary(context, as<grammar::Binary>(node), result);
    case NodeKind::conditional: return evaluate_conditional(context, as<grammar::Conditional>(node), result);
    case NodeKind::call: return evaluate_call(context, as<grammar::Call>(node), result);
    default: return evaluate_rare_into(context, node, result);
  }
}

std::vector<double> evaluate_coordinates(Context& context, const grammar::Vector& node) {
  std::vector<double> numbers;
  evaluate_each_coordinate(context, node.coordinates, [&](double number) { numbers.push_back(number); });
  return numbers;
}

double compute_number(Context& context, const Node& node) {
  Value value;
  evaluate_into(context, node, value);
  if (!value.is_number()) [[unlikely]]
    context.fail(node.span, fmt::format("expected a number, found {}", describe(value)),
                 value.kind() == ValueKind::string ? "`val(…)` converts a string to a number" : "");
  return value.number();
}

bool evaluate_condition(Context& context, const Node& node) {
  return std::abs(compute_number(context, node)) > kTolerance;
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

// ---- Macro calls and directives as values ---------------------------------------------------------------------------

namespace {

Value read_only_value(ElementStream& stream) {
  Value value = read_rvalue(stream);
  stream.accept(ElementKind::semicolon);
  const Element& next = stream.peek();
  if (!next.is(ElementKind::end)) stream.context().fail(next.span, "expected one value, found a second");
  return value;
}

constexpr const char* kYieldsNothing = "this macro call yields no value";

}  // namespace

[[gnu::noinline]] void evaluate_call(Context& context, const grammar::Call& call, Value& result) {
  const Value& callee = called(context, call);
  if (is_callable(callee)) {
    result = call_function(context, call, callee);
    return;
  }
  const auto& macro = callee.as<MacroValue>();
  const Routine* const routine = routine_of(context, macro);
  if (routine) return call_routine(context, call, macro, *routine, kYieldsNothing, result);
  ElementStream stream(context, call, macro);
  if (stream.peek().is(ElementKind::end)) context.fail(call.span, kYieldsNothing);
  result = read_only_value(stream);
}

[[gnu::noinline]] Value evaluate_items(Context& context, Items items, SourceSpan span) {
  ElementStream stream(context, items, span);
  if (stream.peek().is(ElementKind::end)) context.fail(span, "expected a value, found none");
  return read_only_value(stream);
}

}  // namespace isl::interpreter
