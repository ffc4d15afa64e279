#include "interpreter/routines/operations.h"

#include "interpreter/builtins/characters.h"
#include "interpreter/control.h"
#include "interpreter/directives.h"
#include "interpreter/expressions.h"
#include "interpreter/operators.h"

#include <array>
#include <cmath>

namespace isl::interpreter::operations {
namespace {

using grammar::as;
using grammar::BinaryOp;
using grammar::Node;
using grammar::NodeKind;
using grammar::Symbol;
using grammar::UnaryOp;

const Operation* elsewhere(const Operation* at) { return at + at->other; }

/// Goes on at an operation: an optimising compiler makes the call a jump, so that each operation has a branch of its
/// own to its next one, which processors foresee better than a common one. Without that the loop in run() calls it. A
/// turn of a loop always ends there.
[[gnu::always_inline]] inline const Operation* next(Machine& machine, const Operation* at) {
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
  return at->perform(machine, at);
#else
  static_cast<void>(machine);
  return at;
#endif
}

// ---- Operands: the place of a number, or null -----------------------------------------------------------------------

struct Name {
  static const double* at(const Machine& machine, std::uint32_t symbol) {
    const Slot* const slot = machine.scopes.find_known(Symbol{symbol});
    return slot && slot->value.is_number() ? slot->value.terms().data() : nullptr;
  }
};
struct Register {
  static const double* at(const Machine& machine, std::uint32_t index) { return &machine.registers[index]; }
};
struct Constant {
  static const double* at(const Machine& machine, std::uint32_t index) { return machine.constants + index; }
};

/// The functions of one operation by the source of its operand.
template <template <class> class Row>
Perform by_source(Source source) {
  static constexpr Perform kRows[] = {Row<Name>::perform, Row<Register>::perform, Row<Constant>::perform};
  return kRows[static_cast<std::size_t>(source)];
}

// ---- Numbers --------------------------------------------------------------------------------------------------------

template <class Operand>
struct Load {
  static const Operation* perform(Machine& machine, const Operation* at) {
    const double* const number = Operand::at(machine, at->a);
    if (!number) [[unlikely]]
      return elsewhere(at);
    machine.registers[at->to] = *number;
    return next(machine, at + 1);
  }
};

/// Declares a name that holds no number yet.
template <bool is_local>
[[gnu::noinline]] const Operation* declare_anew(Machine& machine, const Operation* at, Symbol name, double number) {
  Slot& slot = is_local ? machine.scopes.local(name) : machine.scopes.declare(name);
  if (slot.value.kind() >= ValueKind::function) [[unlikely]]
    return elsewhere(at);
  slot.value.set_number(number);
  return next(machine, at + 1);
}

template <bool is_local>
const Operation* declare_number(Machine& machine, const Operation* at, Symbol name, double number) {
  Slot* const slot = is_local ? nullptr : machine.scopes.find_known(name);
  if (!slot || !slot->value.is_number()) return declare_anew<is_local>(machine, at, name, number);
  slot->value.change_number(number);
  return next(machine, at + 1);
}

/// These two put the result of a binary operator into the place `to`.
struct ToRegister {
  static const Operation* put(Machine& machine, const Operation* at, double result) {
    machine.registers[at->to] = result;
    return next(machine, at + 1);
  }
};
struct ToName {
  static const Operation* put(Machine& machine, const Operation* at, double result) {
    return declare_number<false>(machine, at, Symbol{at->to}, result);
  }
};

template <class To, BinaryOp op, class Left, class Right>
const Operation* perform_binary(Machine& machine, const Operation* at) {
  const double* const left = Left::at(machine, at->a);
  const double* const right = Right::at(machine, at->b);
  if (!left || !right) [[unlikely]]
    return elsewhere(at);
  if constexpr (op == BinaryOp::add) return To::put(machine, at, *left + *right);
  if constexpr (op == BinaryOp::subtract) return To::put(machine, at, *left - *right);
  if constexpr (op == BinaryOp::multiply) return To::put(machine, at, *left * *right);
  if constexpr (op == BinaryOp::divide) {
    if (*right == 0) [[unlikely]]
      return elsewhere(at);
    return To::put(machine, at, *left / *right);
  }
  return To::put(machine, at, compare(op, *left, *right));
}

constexpr std::size_t kSources = 3, kBinaryOps = static_cast<std::size_t>(BinaryOp::logical_or) + 1;
using BySources = std::array<Perform, kSources * kSources>;

template <class To, BinaryOp op>
constexpr BySources rows_of() {
  return {perform_binary<To, op, Name, Name>,         perform_binary<To, op, Name, Register>,
          perform_binary<To, op, Name, Constant>,     perform_binary<To, op, Register, Name>,
          perform_binary<To, op, Register, Register>, perform_binary<To, op, Register, Constant>,
          perform_binary<To, op, Constant, Name>,     perform_binary<To, op, Constant, Register>,
          perform_binary<To, op, Constant, Constant>};
}

template <class To, std::size_t... op>
constexpr std::array<BySources, kBinaryOps> all_rows(std::index_sequence<op...>) {
  return {rows_of<To, static_cast<BinaryOp>(op)>()...};
}

template <class To>
Perform binary_to(BinaryOp op, Source left, Source right) {
  static constexpr auto kRows = all_rows<To>(std::make_index_sequence<kBinaryOps>());
  return kRows[static_cast<std::size_t>(op)]
              [static_cast<std::size_t>(left) * kSources + static_cast<std::size_t>(right)];
}

template <UnaryOp op, class Operand>
const Operation* perform_unary(Machine& machine, const Operation* at) {
  const double* const number = Operand::at(machine, at->a);
  if (!number) [[unlikely]]
    return elsewhere(at);
  machine.registers[at->to] = applied(op, *number);
  return next(machine, at + 1);
}

template <class Operand>
struct Plus {
  static constexpr Perform perform = perform_unary<UnaryOp::plus, Operand>;
};
template <class Operand>
struct Minus {
  static constexpr Perform perform = perform_unary<UnaryOp::minus, Operand>;
};
template <class Operand>
struct Not {
  static constexpr Perform perform = perform_unary<UnaryOp::logical_not, Operand>;
};

const Operation* perform_compare_texts(Machine& machine, const Operation* at) {
  const std::optional<double> result = compare_texts(machine.context, as<grammar::Binary>(*at->node));
  if (!result) [[unlikely]]
    return elsewhere(at);
  machine.registers[at->to] = *result;
  return next(machine, at + 1);
}

const Operation* perform_item(Machine& machine, const Operation* at) {
  const Slot* const slot = machine.scopes.find_known(Symbol{at->a});
  const auto term = static_cast<int>(at->b);
  const bool has_item = slot && slot->value.term_count() > std::max(term, 1);
  if (!has_item) [[unlikely]]
    return elsewhere(at);
  machine.registers[at->to] = slot->value.terms()[at->b];
  return next(machine, at + 1);
}

struct ListElement {
  ArrayElements* list;
  std::size_t place;
};

/// The list is null if the name holds none or it has no such element.
inline ListElement element_of(const Machine& machine, std::uint32_t symbol, double index) {
  const Slot* const slot = machine.scopes.find_known(Symbol{symbol});
  if (!slot || slot->value.kind() != ValueKind::array) [[unlikely]]
    return {};
  ArrayValue& array = slot->value.as<ArrayValue>();
  // The signed conversion is one instruction. What is too large for it, or no number, becomes the least integer, and
  // so a place behind every array's end.
  const double place = index + kTolerance;
  const auto whole = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(place));
  if (!(place >= 0) || whole >= array.elements.size() || array.dimensions.size() != 1) [[unlikely]]
    return {};
  return {&array.elements, whole};
}

template <class Index>
struct Element {
  static const Operation* perform(Machine& machine, const Operation* at) {
    const double* const index = Index::at(machine, at->a);
    if (!index) [[unlikely]]
      return elsewhere(at);
    const auto [list, place] = element_of(machine, at->b, *index);
    const double* const number = list ? list->number(place) : nullptr;
    if (!number) [[unlikely]]
      return elsewhere(at);
    machine.registers[at->to] = *number;
    return next(machine, at + 1);
  }
};

const Operation* perform_call(Machine& machine, const Operation* at) {
  const NumberFunction& function = *at->function;
  const double* const arguments = &machine.registers[at->a];
  double& result = machine.registers[at->to];
  if (function.of_one) {
    result = function.of_one(arguments[0]);
    return next(machine, at + 1);
  }
  double answer = 0;
  if (!function.apply(arguments[0], function.arguments == 2 ? arguments[1] : 0, answer)) [[unlikely]]
    return elsewhere(at);
  result = answer;
  return next(machine, at + 1);
}

const Operation* perform_choice(Machine& machine, const Operation* at) {
  double& condition = machine.registers[at->to];
  condition = machine.registers[std::abs(condition) > kTolerance ? at->a : at->b];
  return next(machine, at + 1);
}

// ---- Declarations ---------------------------------------------------------------------------------------------------

template <bool is_local, class Operand>
const Operation* perform_declaration(Machine& machine, const Operation* at) {
  const double* const number = Operand::at(machine, at->a);
  if (!number) [[unlikely]]
    return elsewhere(at);
  return declare_number<is_local>(machine, at, Symbol{at->b}, *number);
}

template <class Operand>
struct Declare {
  static constexpr Perform perform = perform_declaration<false, Operand>;
};
template <class Operand>
struct DeclareLocal {
  static constexpr Perform perform = perform_declaration<true, Operand>;
};

template <class Operand, class Index>
const Operation* perform_element_declaration(Machine& machine, const Operation* at) {
  const double* const number = Operand::at(machine, at->a);
  const double* const index = Index::at(machine, at->to);
  if (!number || !index) [[unlikely]]
    return elsewhere(at);
  const auto [list, place] = element_of(machine, at->b, *index);
  if (!list || !list->set_number(place, *number)) [[unlikely]]
    return elsewhere(at);
  return next(machine, at + 1);
}

template <class Operand>
constexpr std::array<Perform, kSources> kElementRow = {perform_element_declaration<Operand, Name>,
                                                       perform_element_declaration<Operand, Register>,
                                                       perform_element_declaration<Operand, Constant>};

template <class Operand>
struct Yield {
  static const Operation* perform(Machine& machine, const Operation* at) {
    const double* const number = Operand::at(machine, at->a);
    if (!number) [[unlikely]]
      return elsewhere(at);
    machine.result->set_number(*number);
    machine.has_result = true;
    return nullptr;
  }
};

/// The string of a name, if no other value shares it; else null.
StringValue* own_string(const Machine& machine, std::uint32_t symbol) {
  const Slot* const slot = machine.scopes.find_known(Symbol{symbol});
  const bool is_own = slot && slot->value.kind() == ValueKind::string && slot->value.is_only_owner();
  return is_own ? &slot->value.as<StringValue>() : nullptr;
}

void append(Machine& machine, StringValue& to, std::string_view more, const Node& node) {
  const std::size_t size = to.text.size() + more.size();
  // A string that grows takes twice its size.
  if (size > to.text.capacity()) machine.context.check_memory(node.span, 2 * size);
  to.append(more);
}

const Operation* perform_append_text(Machine& machine, const Operation* at) {
  StringValue* const string = own_string(machine, at->a);
  const std::optional<std::string_view> more = text_at_hand(machine.context, *at->node);
  if (!string || !more) [[unlikely]]
    return elsewhere(at);
  append(machine, *string, *more, *at->node);
  return at + 1;
}

const Operation* perform_append_character(Machine& machine, const Operation* at) {
  StringValue* const string = own_string(machine, at->a);
  const double code = machine.registers[at->b];
  const bool is_character = code > -1 && code < 0x10000;
  if (!string || !is_character) [[unlikely]]
    return elsewhere(at);
  append(machine, *string, character_of(static_cast<char32_t>(code)), *at->node);
  return at + 1;
}

// ---- Control --------------------------------------------------------------------------------------------------------

const Operation* perform_jump(Machine&, const Operation* at) { return elsewhere(at); }
const Operation* perform_end(Machine&, const Operation*) { return nullptr; }

const Operation* perform_jump_unless(Machine& machine, const Operation* at) {
  return next(machine, std::abs(machine.registers[at->a]) > kTolerance ? at + 1 : elsewhere(at));
}

const Operation* perform_jump_unless_declared(Machine& machine, const Operation* at) {
  const auto& node = as<grammar::Ifdef>(*at->node);
  return is_declared(machine.context, *node.target) != node.negated ? at + 1 : elsewhere(at);
}

const Operation* perform_count_turn(Machine& machine, const Operation* at) {
  machine.context.count_turn(at->node->span);
  return next(machine, at + 1);
}

const Operation* perform_begin_for(Machine& machine, const Operation* at) {
  const double* const range = &machine.registers[at->to];
  const bool has_turn = begin_for(machine.context, as<grammar::For>(*at->node), range[0], {range[1], range[2]});
  return has_turn ? at + 1 : elsewhere(at);
}

/// Tells the scene that the variable holds no number.
[[gnu::noinline]] const Operation* next_for_without_number(Machine& machine, const Operation* at) {
  const double* const range = &machine.registers[at->to];
  return next_for(machine.context, as<grammar::For>(*at->node), {range[1], range[2]}) ? elsewhere(at) : at + 1;
}

const Operation* perform_next_for(Machine& machine, const Operation* at) {
  const auto& node = as<grammar::For>(*at->node);
  Slot* const slot = machine.scopes.find_known(node.variable);
  if (!slot || !slot->value.is_number()) [[unlikely]]
    return next_for_without_number(machine, at);
  const double* const range = &machine.registers[at->to];
  const double value = slot->value.number() + range[2];
  slot->value.change_number(value);
  if (!has_turn(value, range[1], range[2])) return next(machine, at + 1);
  machine.context.count_turn(node.span);
  return elsewhere(at);
}

// ---- The evaluator --------------------------------------------------------------------------------------------------

const Operation* perform_evaluation(Machine& machine, const Operation* at) {
  machine.registers[at->to] = interpreter::evaluate_number(machine.context, *at->node);
  return elsewhere(at);
}

const Operation* perform_evaluated_declaration(Machine& machine, const Operation* at) {
  declare_in_routine(machine.context, as<grammar::Declare>(*at->node));
  return elsewhere(at);
}

const Operation* perform_evaluated_yield(Machine& machine, const Operation* at) {
  const Node& node = *at->node;
  const bool is_unknown = node.kind == NodeKind::name && !machine.scopes.find(as<grammar::Name>(node).name);
  if (is_unknown) [[unlikely]] {
    // A reader of elements says what it expects instead.
    const Node* const items[] = {&node};
    *machine.result = evaluate_items(machine.context, grammar::Items(items), node.span);
  } else {
    evaluate_into(machine.context, node, *machine.result);
  }
  machine.has_result = true;
  return nullptr;
}

}  // namespace

Perform load(Source source) { return by_source<Load>(source); }
Perform binary(BinaryOp op, Source left, Source right) { return binary_to<ToRegister>(op, left, right); }
Perform declare_binary(BinaryOp op, Source left, Source right) { return binary_to<ToName>(op, left, right); }
Perform unary(UnaryOp op, Source operand) {
  switch (op) {
    case UnaryOp::plus: return by_source<Plus>(operand);
    case UnaryOp::minus: return by_source<Minus>(operand);
    case UnaryOp::logical_not: return by_source<Not>(operand);
  }
  ISL_CHECK(false, "operator {}", static_cast<int>(op));
}
Perform compare_texts() { return perform_compare_texts; }
Perform item() { return perform_item; }
Perform element(Source index) { return by_source<Element>(index); }
Perform call() { return perform_call; }
Perform choose() { return perform_choice; }
Perform declare(bool is_local, Source value) {
  return is_local ? by_source<DeclareLocal>(value) : by_source<Declare>(value);
}
Perform declare_element(Source value, Source index) {
  static constexpr std::array<Perform, kSources> kRows[] = {kElementRow<Name>, kElementRow<Register>,
                                                            kElementRow<Constant>};
  return kRows[static_cast<std::size_t>(value)][static_cast<std::size_t>(index)];
}
Perform append_text() { return perform_append_text; }
Perform append_character() { return perform_append_character; }
Perform yield(Source value) { return by_source<Yield>(value); }
Perform jump() { return perform_jump; }
Perform jump_unless() { return perform_jump_unless; }
Perform jump_unless_declared() { return perform_jump_unless_declared; }
Perform end() { return perform_end; }
Perform count_turn() { return perform_count_turn; }
Perform begin_for() { return perform_begin_for; }
Perform next_for() { return perform_next_for; }
Perform evaluate_number() { return perform_evaluation; }
Perform evaluate_declaration() { return perform_evaluated_declaration; }
Perform evaluate_yield() { return perform_evaluated_yield; }

}  // namespace isl::interpreter::operations
