#include "interpreter/routines/routine_builder.h"

#include "interpreter/operators.h"
#include "interpreter/routines/operations.h"

#include <cstddef>
#include <numbers>
#include <utility>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Items;
using grammar::Node;
using grammar::NodeKind;
using grammar::Symbol;
namespace op = operations;
namespace word = grammar::word;

constexpr Source kRegister = Source::register_;

struct Operand {
  Source source;
  std::uint32_t index;
};

/// An argument of a call of this function with so many arguments, if it is one expression; else null.
const Node* lone_argument(const grammar::FunctionCall& call, Symbol function, std::size_t i, std::size_t count) {
  const bool is_one = call.function == function && call.arguments.size() == count && call.arguments[i].size() == 1;
  return is_one ? call.arguments[i].front() : nullptr;
}

class RoutineBuilder {
 public:
  RoutineBuilder(Context& context, bool is_macro) : context_(context), is_macro_(is_macro) {}

  /// Each is false if the routine cannot have such an item.
  [[nodiscard]] bool add_items(Items items, bool is_last);
  [[nodiscard]] bool add_loop(const Node& loop);
  [[nodiscard]] Routine finish();

 private:
  using Index = std::size_t;

  /// The evaluator's way of a statement whose operations lie in [begin, end), or of the one at `end` alone. It goes on
  /// at `end`.
  struct Detour {
    Index begin, end;
    Operation operation;
  };

  /// The operation of the binary operator that was added last.
  struct LastOperator {
    Index at;
    grammar::BinaryOp op;
    Source left, right;
  };

  // ---- Statements ---------------------------------------------------------------------------------------------------

  [[nodiscard]] bool add_declaration(const grammar::Declare& node);
  /// `#declare Name = concat(Name, …)` with a string at hand or a character.
  [[nodiscard]] bool add_append(const grammar::Declare& node, const Node& only);
  void add_name_declaration(const grammar::Declare& node, const Operand& value, Index begin);
  [[nodiscard]] bool add_element_declaration(const grammar::Declare& node, const Operand& value);
  [[nodiscard]] bool add_branches(Index otherwise_jump, Items then, Items otherwise, bool is_last);
  [[nodiscard]] bool add_if(const grammar::If& node, bool is_last);
  [[nodiscard]] bool add_ifdef(const grammar::Ifdef& node, bool is_last);
  [[nodiscard]] bool add_while(const grammar::While& node);
  [[nodiscard]] bool add_for(const grammar::For& node);
  [[nodiscard]] bool add_break();
  void add_yield(const Node& node);

  // ---- Numbers ------------------------------------------------------------------------------------------------------

  /// Adds the operations for a number and tells where it is; none if the evaluator must do it. New registers begin at
  /// the present number.
  [[nodiscard]] std::optional<Operand> number(const Node& node);
  [[nodiscard]] std::optional<Operand> number_of_binary(const grammar::Binary& node);
  [[nodiscard]] std::optional<Operand> number_of_conditional(const grammar::Conditional& node);
  [[nodiscard]] std::optional<Operand> number_of_call(const grammar::FunctionCall& node);
  [[nodiscard]] std::optional<Operand> number_of_constant(const grammar::Constant& node);
  /// The same in the register `to`.
  [[nodiscard]] bool number_in(const Node& node, std::uint32_t to);
  /// The number in the register `to`, by the evaluator if need be.
  void add_number_in(const Node& node, std::uint32_t to);
  [[nodiscard]] Operand constant(double value);
  /// The name of a one-dimensional array and its subscript, or null.
  [[nodiscard]] static const grammar::Name* name_of_list(const Node& target);

  // ---- The list -----------------------------------------------------------------------------------------------------

  [[nodiscard]] Index here() const { return routine_.operations.size(); }
  Index add(Perform perform, std::uint32_t a = 0, std::uint32_t b = 0, std::uint32_t to = 0);
  Index add(Perform perform, const Node& node, std::uint32_t to = 0);
  void set_other(Index at, Index target);
  /// The operation `at` goes to here.
  void land(Index at) { set_other(at, here()); }
  [[nodiscard]] std::uint32_t symbol(Symbol name);
  /// The next register, or none if there are no more.
  [[nodiscard]] bool has_register() const { return registers_ < Machine::kRegisters; }
  /// Takes back what was added since `begin`: the evaluator does it.
  void take_back(Index begin) { routine_.operations.resize(begin); }

  Context& context_;
  const bool is_macro_;
  Routine routine_;
  std::vector<Detour> detours_;
  LastOperator last_operator_{};
  std::uint32_t registers_ = 0;             ///< in use
  std::vector<std::vector<Index>> breaks_;  ///< of each loop around: the jumps out of it
  std::vector<Index> returns_;              ///< #break outside loops
};

// ---- The list -------------------------------------------------------------------------------------------------------

RoutineBuilder::Index RoutineBuilder::add(Perform perform, std::uint32_t a, std::uint32_t b, std::uint32_t to) {
  routine_.operations.push_back({perform, nullptr, a, b, to, 0});
  return here() - 1;
}

RoutineBuilder::Index RoutineBuilder::add(Perform perform, const Node& node, std::uint32_t to) {
  routine_.operations.push_back({perform, &node, 0, 0, to, 0});
  return here() - 1;
}

void RoutineBuilder::set_other(Index at, Index target) {
  routine_.operations[at].other =
      static_cast<std::int32_t>(static_cast<std::ptrdiff_t>(target) - static_cast<std::ptrdiff_t>(at));
}

std::uint32_t RoutineBuilder::symbol(Symbol name) {
  context_.scopes.make_room_for(name);
  return static_cast<std::uint32_t>(name);
}

Routine RoutineBuilder::finish() {
  for (const Index at : returns_) land(at);
  add(op::end());
  for (const Detour& detour : detours_) {
    for (Index at = detour.begin; at < detour.end; ++at) set_other(at, here());
    routine_.operations.push_back(detour.operation);
    set_other(here() - 1, detour.end);
  }
  return std::move(routine_);
}

// ---- Statements -----------------------------------------------------------------------------------------------------

bool RoutineBuilder::add_items(Items items, bool is_last) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Node& node = *items[i];
    const bool ends = is_last && i + 1 == items.size();
    switch (node.kind) {
      case NodeKind::declare:
        // Its semicolon is the next item.
        if (++i == items.size() || items[i]->kind != NodeKind::semicolon) return false;
        if (!add_declaration(as<grammar::Declare>(node))) return false;
        break;
      case NodeKind::if_:
        if (!add_if(as<grammar::If>(node), ends)) return false;
        break;
      case NodeKind::ifdef:
        if (!add_ifdef(as<grammar::Ifdef>(node), ends)) return false;
        break;
      case NodeKind::while_:
      case NodeKind::for_:
        if (!add_loop(node)) return false;
        break;
      case NodeKind::break_:
        if (!add_break()) return false;
        break;
      default:
        // An expression is a macro's value. What a called macro yields is its reader's to tell.
        if (!ends || !is_macro_ || node.kind >= NodeKind::word || node.kind == NodeKind::call) return false;
        add_yield(node);
    }
  }
  return true;
}

bool RoutineBuilder::add_loop(const Node& loop) {
  return loop.kind == NodeKind::while_ ? add_while(as<grammar::While>(loop)) : add_for(as<grammar::For>(loop));
}

bool RoutineBuilder::add_declaration(const grammar::Declare& node) {
  const Node* const only = node.value.size() == 1 ? node.value[0] : nullptr;
  if (!only || only->kind >= NodeKind::word || only->kind == NodeKind::call) return false;
  const Index begin = here();
  const std::uint32_t registers = registers_;
  if (add_append(node, *only)) {
    detours_.push_back({begin, here(), {op::evaluate_declaration(), &node, 0, 0, 0, 0}});
    return true;
  }
  std::optional<Operand> value = number(*only);
  if (value && node.target->kind == NodeKind::name) {
    add_name_declaration(node, *value, begin);
  } else if (!value || !add_element_declaration(node, *value)) {
    value.reset();
  }
  registers_ = registers;
  if (!value) {
    take_back(begin);
    land(add(op::evaluate_declaration(), node));
    return true;
  }
  detours_.push_back({begin, here(), {op::evaluate_declaration(), &node, 0, 0, 0, 0}});
  return true;
}

bool RoutineBuilder::add_append(const grammar::Declare& node, const Node& only) {
  if (node.local || node.target->kind != NodeKind::name || only.kind != NodeKind::function_call) return false;
  const auto& concat = as<grammar::FunctionCall>(only);
  const Node* const first = lone_argument(concat, word::kw_concat, 0, 2);
  const Node* const more = lone_argument(concat, word::kw_concat, 1, 2);
  if (!first || !more || first->kind != NodeKind::name) return false;
  const Symbol name = as<grammar::Name>(*node.target).name;
  if (as<grammar::Name>(*first).name != name) return false;
  if (more->kind == NodeKind::name || more->kind == NodeKind::string) {
    const Index at = add(op::append_text(), *more);
    routine_.operations[at].a = symbol(name);
    return true;
  }
  if (more->kind != NodeKind::function_call) return false;
  const Node* const code = lone_argument(as<grammar::FunctionCall>(*more), word::kw_chr, 0, 1);
  const Index begin = here();
  if (!code || !number_in(*code, registers_)) {
    take_back(begin);
    return false;
  }
  const Index at = add(op::append_character(), *more);
  routine_.operations[at].a = symbol(name);
  routine_.operations[at].b = registers_;
  return true;
}

void RoutineBuilder::add_name_declaration(const grammar::Declare& node, const Operand& value, Index begin) {
  const std::uint32_t name = symbol(as<grammar::Name>(*node.target).name);
  const bool is_of_operator = here() > begin && last_operator_.at == here() - 1 && !node.local;
  if (!is_of_operator) {
    add(op::declare(node.local, value.source), value.index, name);
    return;
  }
  Operation& last = routine_.operations.back();
  last.perform = op::declare_binary(last_operator_.op, last_operator_.left, last_operator_.right);
  last.to = name;
}

bool RoutineBuilder::add_element_declaration(const grammar::Declare& node, const Operand& value) {
  const grammar::Name* const list = name_of_list(*node.target);
  if (value.source == kRegister) ++registers_;
  if (!list || !has_register()) return false;
  const std::optional<Operand> index = number(*as<grammar::Index>(*node.target).subscript);
  if (!index) return false;
  add(op::declare_element(value.source, index->source), value.index, symbol(list->name), index->index);
  return true;
}

bool RoutineBuilder::add_branches(Index otherwise_jump, Items then, Items otherwise, bool is_last) {
  if (!add_items(then, is_last)) return false;
  if (otherwise.empty()) {
    land(otherwise_jump);
    return true;
  }
  const Index end_jump = add(op::jump());
  land(otherwise_jump);
  if (!add_items(otherwise, is_last)) return false;
  land(end_jump);
  return true;
}

bool RoutineBuilder::add_if(const grammar::If& node, bool is_last) {
  if (!has_register()) return false;
  add_number_in(*node.condition, registers_);
  return add_branches(add(op::jump_unless(), registers_), node.then, node.otherwise, is_last);
}

bool RoutineBuilder::add_ifdef(const grammar::Ifdef& node, bool is_last) {
  return add_branches(add(op::jump_unless_declared(), node), node.then, node.otherwise, is_last);
}

bool RoutineBuilder::add_while(const grammar::While& node) {
  if (!has_register()) return false;
  const Index begin = here();
  add_number_in(*node.condition, registers_);
  breaks_.emplace_back();
  breaks_.back().push_back(add(op::jump_unless(), registers_));
  add(op::count_turn(), node);
  if (!add_items(node.body, false)) return false;
  set_other(add(op::jump()), begin);
  for (const Index at : breaks_.back()) land(at);
  breaks_.pop_back();
  return true;
}

bool RoutineBuilder::add_for(const grammar::For& node) {
  constexpr std::uint32_t kOfRange = 3;
  if (registers_ + kOfRange > Machine::kRegisters) return false;
  static_cast<void>(symbol(node.variable));
  const std::uint32_t range = registers_;
  const Node* const parts[kOfRange] = {node.start, node.end, node.step};
  for (const Node* const part : parts) {
    if (part) {
      add_number_in(*part, registers_);
    } else {
      add(op::load(Source::constant), constant(1).index, 0, registers_);
    }
    ++registers_;
  }
  breaks_.emplace_back();
  breaks_.back().push_back(add(op::begin_for(), node, range));
  add(op::count_turn(), node);
  const Index turn = here();
  if (!add_items(node.body, false)) return false;
  set_other(add(op::next_for(), node, range), turn);
  for (const Index at : breaks_.back()) land(at);
  breaks_.pop_back();
  registers_ = range;
  return true;
}

bool RoutineBuilder::add_break() {
  if (breaks_.empty() && !is_macro_) return false;
  (breaks_.empty() ? returns_ : breaks_.back()).push_back(add(op::jump()));
  return true;
}

void RoutineBuilder::add_yield(const Node& node) {
  routine_.yields = true;
  const Index begin = here();
  const Operation detour{op::evaluate_yield(), &node, 0, 0, 0, 0};
  if (const std::optional<Operand> value = number(node)) {
    add(op::yield(value->source), value->index);
    detours_.push_back({begin, here(), detour});
  } else {
    take_back(begin);
    routine_.operations.push_back(detour);
  }
}

// ---- Numbers --------------------------------------------------------------------------------------------------------

void RoutineBuilder::add_number_in(const Node& node, std::uint32_t to) {
  const Index begin = here();
  if (number_in(node, to)) {
    detours_.push_back({begin, here(), {op::evaluate_number(), &node, 0, 0, to, 0}});
  } else {
    take_back(begin);
    land(add(op::evaluate_number(), node, to));
  }
}

bool RoutineBuilder::number_in(const Node& node, std::uint32_t to) {
  const std::uint32_t registers = std::exchange(registers_, to);
  const std::optional<Operand> value = number(node);
  registers_ = registers;
  if (!value) return false;
  if (value->source != kRegister || value->index != to) add(op::load(value->source), value->index, 0, to);
  return true;
}

Operand RoutineBuilder::constant(double value) {
  routine_.constants.push_back(value);
  return {Source::constant, static_cast<std::uint32_t>(routine_.constants.size() - 1)};
}

const grammar::Name* RoutineBuilder::name_of_list(const Node& target) {
  if (target.kind != NodeKind::index) return nullptr;
  const Node& base = *as<grammar::Index>(target).base;
  return base.kind == NodeKind::name ? &as<grammar::Name>(base) : nullptr;
}

std::optional<Operand> RoutineBuilder::number(const Node& node) {
  const std::uint32_t to = registers_;
  if (!has_register()) return {};
  switch (node.kind) {
    case NodeKind::number: return constant(as<grammar::Number>(node).value);
    case NodeKind::name: return Operand{Source::name, symbol(as<grammar::Name>(node).name)};
    case NodeKind::constant: return number_of_constant(as<grammar::Constant>(node));
    case NodeKind::binary: return number_of_binary(as<grammar::Binary>(node));
    case NodeKind::conditional: return number_of_conditional(as<grammar::Conditional>(node));
    case NodeKind::function_call: return number_of_call(as<grammar::FunctionCall>(node));
    case NodeKind::dot: {
      const auto& dot = as<grammar::Dot>(node);
      const int term = term_of_item(dot.item);
      if (dot.base->kind != NodeKind::name || term < 0) return {};
      add(op::item(), symbol(as<grammar::Name>(*dot.base).name), static_cast<std::uint32_t>(term), to);
      return Operand{kRegister, to};
    }
    case NodeKind::index: {
      const grammar::Name* const list = name_of_list(node);
      const std::optional<Operand> index = list ? number(*as<grammar::Index>(node).subscript) : std::nullopt;
      if (!index) return {};
      add(op::element(index->source), index->index, symbol(list->name), to);
      return Operand{kRegister, to};
    }
    case NodeKind::unary: {
      const auto& unary = as<grammar::Unary>(node);
      if (unary.negative) return constant(*unary.negative);
      const std::optional<Operand> operand = number(*unary.operand);
      if (!operand) return {};
      add(op::unary(unary.op, operand->source), operand->index, 0, to);
      return Operand{kRegister, to};
    }
    default: return {};
  }
}

std::optional<Operand> RoutineBuilder::number_of_constant(const grammar::Constant& node) {
  switch (static_cast<word::Index>(node.word)) {
    case word::kIndex_pi: return constant(std::numbers::pi);
    case word::kIndex_yes:
    case word::kIndex_on:
    case word::kIndex_true: return constant(1);
    case word::kIndex_no:
    case word::kIndex_off:
    case word::kIndex_false: return constant(0);
    default: return {};
  }
}

std::optional<Operand> RoutineBuilder::number_of_binary(const grammar::Binary& node) {
  const std::uint32_t to = registers_;
  // With a literal it is a comparison of strings, or a mistake.
  if (node.left->kind == NodeKind::string || node.right->kind == NodeKind::string) {
    add(op::compare_texts(), node, to);
    return Operand{kRegister, to};
  }
  const std::optional<Operand> left = number(*node.left);
  if (!left) return {};
  // The right side must leave the left one's register alone.
  if (left->source == kRegister) ++registers_;
  const std::optional<Operand> right = number(*node.right);
  registers_ = to;
  if (!right) return {};
  add(op::binary(node.op, left->source, right->source), left->index, right->index, to);
  last_operator_ = {here() - 1, node.op, left->source, right->source};
  return Operand{kRegister, to};
}

std::optional<Operand> RoutineBuilder::number_of_conditional(const grammar::Conditional& node) {
  const std::uint32_t to = registers_;
  if (to + 3 > Machine::kRegisters) return {};
  if (!number_in(*node.condition, to)) return {};
  registers_ = to + 1;
  const bool has_yes = number_in(*node.yes, to + 1);
  registers_ = to + 2;
  const bool has_both = has_yes && number_in(*node.no, to + 2);
  registers_ = to;
  if (!has_both) return {};
  add(op::choose(), to + 1, to + 2, to);
  return Operand{kRegister, to};
}

std::optional<Operand> RoutineBuilder::number_of_call(const grammar::FunctionCall& node) {
  const NumberFunction* const function = number_function(node.function);
  const std::uint32_t to = registers_;
  if (!function || node.arguments.size() != function->arguments) return {};
  if (to + node.arguments.size() > Machine::kRegisters) return {};
  for (const grammar::Argument& argument : node.arguments) {
    const bool is_plain = argument.size() == 1 && number_in(*argument[0], registers_);
    if (!is_plain) {
      registers_ = to;
      return {};
    }
    ++registers_;
  }
  registers_ = to;
  const Index at = add(op::call(), to, 0, to);
  routine_.operations[at].function = function;
  return Operand{kRegister, to};
}

[[nodiscard]] std::optional<Routine> charged(Context& context, RoutineBuilder& builder, SourceSpan span) {
  Routine routine = builder.finish();
  context.check_memory(span, routine.bytes());
  context.memory.add(routine.bytes());
  return routine;
}

}  // namespace

std::optional<Routine> routine_of_loop(Context& context, const Node& loop) {
  RoutineBuilder builder(context, /*is_macro=*/false);
  if (!builder.add_loop(loop)) return {};
  return charged(context, builder, loop.span);
}

std::optional<Routine> routine_of_macro(Context& context, const grammar::Macro& macro) {
  RoutineBuilder builder(context, /*is_macro=*/true);
  if (!builder.add_items(macro.body, /*is_last=*/true)) return {};
  return charged(context, builder, macro.span);
}

}  // namespace isl::interpreter
