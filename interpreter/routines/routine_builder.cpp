#include "interpreter/routines/routine_builder.h"

#include "interpreter/routines/building.h"

#include <cstddef>
#include <utility>

namespace isl::interpreter {

using grammar::as;
using grammar::Items;
using grammar::Node;
using grammar::NodeKind;
using grammar::Symbol;
namespace op = operations;
namespace word = grammar::word;

namespace {

/// An argument of a call of this function with so many arguments, if it is one expression; else null.
const Node* lone_argument(const grammar::FunctionCall& call, Symbol function, std::size_t i, std::size_t count) {
  const bool is_one = call.function == function && call.arguments.size() == count && call.arguments[i].size() == 1;
  return is_one ? call.arguments[i].front() : nullptr;
}

}  // namespace

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
  std::optional<NumberPlace> value = number(*only);
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

void RoutineBuilder::add_name_declaration(const grammar::Declare& node, const NumberPlace& value, Index begin) {
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

bool RoutineBuilder::add_element_declaration(const grammar::Declare& node, const NumberPlace& value) {
  const grammar::Name* const list = name_of_list(*node.target);
  if (value.source == Source::register_) ++registers_;
  if (!list || !has_register()) return false;
  const std::optional<NumberPlace> index = number(*as<grammar::Index>(*node.target).subscript);
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
  if (const std::optional<NumberPlace> value = number(node)) {
    add(op::yield(value->source), value->index);
    detours_.push_back({begin, here(), detour});
  } else {
    take_back(begin);
    routine_.operations.push_back(detour);
  }
}

namespace {

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
