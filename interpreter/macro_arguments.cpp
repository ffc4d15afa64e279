#include "interpreter/macro_arguments.h"

#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/operators.h"
#include "interpreter/readers/rvalue.h"

#include <fmt/format.h>

namespace isl::interpreter {

using grammar::Node;
using grammar::NodeKind;

ArgumentSlots::ArgumentSlots(Context& context, const grammar::Call& call, const grammar::Macro& definition)
    : context_(context), begin_(context.argument_slots.size()) {
  try {
    for (const grammar::Argument& argument : call.arguments) read(argument);
    const std::size_t found = context.argument_slots.size() - begin_;
    const std::size_t wanted = definition.parameters.size();
    if (found != wanted) {
      context.fail(call.span, fmt::format("macro `{}` takes {} argument{}, found {}", context.text(definition.name),
                                          wanted, wanted == 1 ? "" : "s", found));
    }
  } catch (...) {
    release();
    throw;
  }
}

void ArgumentSlots::bind_to(std::span<const grammar::Symbol> parameters) {
  auto& slots = context_.argument_slots;
  for (std::size_t i = 0; i < parameters.size(); ++i) context_.scopes.bind(parameters[i], slots[begin_ + i]);
  slots.resize(begin_);
}

void ArgumentSlots::release() {
  auto& slots = context_.argument_slots;
  for (; slots.size() > begin_; slots.pop_back()) context_.scopes.slots().release(slots.back());
}

void ArgumentSlots::push(Value value) {
  Slot* const slot = context_.scopes.slots().make();
  slot->value = std::move(value);
  context_.argument_slots.push_back(slot);
}

void ArgumentSlots::push_value_of(const Node& node) {
  double number = 0;
  std::optional<Value> other;
  const bool is_number = evaluate_scalar(context_, node, number, other);
  Slot* const slot = context_.scopes.slots().make();
  if (is_number) {
    slot->value.set_number(number);
  } else {
    slot->value = *std::move(other);
  }
  context_.argument_slots.push_back(slot);
}

/// A lone identifier goes by reference; a name that stands for a macro does not.
bool ArgumentSlots::push_reference(const Node& node) {
  if (node.kind != NodeKind::name && node.kind != NodeKind::index) return false;
  Slot& slot = find_slot(context_, node);
  if (slot.value.kind() == ValueKind::poison) throw Failed{};
  context_.scopes.slots().retain(&slot);
  context_.argument_slots.push_back(&slot);
  return true;
}

void ArgumentSlots::read(const grammar::Argument& argument) {
  const bool is_single =
      argument.size() == 1 && argument[0]->kind < NodeKind::word && argument[0]->kind != NodeKind::call;
  if (is_single) {
    if (!push_reference(*argument[0])) push_value_of(*argument[0]);
    return;
  }
  // Several actuals without commas between them, a colour of several words, a block, or whatever a macro yields.
  ElementStream stream(context_, argument, argument.empty() ? SourceSpan{} : argument.front()->span);
  while (!stream.peek().is(ElementKind::end)) {
    const Element next = stream.peek();
    if (next.is(ElementKind::value) && next.word != grammar::kNoSymbol) {
      // Bound before the stream goes on: what follows may end the scope that the name is of.
      stream.drop();
      push_reference(*next.node);
      if (stream.peek().is(ElementKind::word)) {
        Value first = context_.argument_slots.back()->value;
        context_.scopes.slots().release(context_.argument_slots.back());
        context_.argument_slots.pop_back();
        push(read_rvalue_after(stream, std::move(first)));
      }
    } else {
      push(read_rvalue(stream));
    }
    stream.accept_comma();
  }
}

}  // namespace isl::interpreter
