#include "interpreter/macro_arguments.h"

#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
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
  const auto begin = slots.begin() + static_cast<std::ptrdiff_t>(begin_);
  auto slot = begin;
  for (const grammar::Symbol parameter : parameters) context_.scopes.bind(parameter, *slot++);
  slots.erase(begin, slots.end());
}

void ArgumentSlots::release() {
  auto& slots = context_.argument_slots;
  for (; slots.size() > begin_; slots.pop_back()) context_.scopes.slots().release(slots.back());
}

Value& ArgumentSlots::push() {
  Slot* const slot = context_.scopes.slots().make();
  context_.argument_slots.push_back(slot);
  return slot->value;
}

/// A lone identifier goes by reference.
void ArgumentSlots::push_reference(Slot& slot) {
  if (slot.value.kind() == ValueKind::poison) throw Failed{};
  context_.scopes.slots().retain(&slot);
  context_.argument_slots.push_back(&slot);
}

void ArgumentSlots::read(const grammar::Argument& argument) {
  const bool is_single =
      argument.size() == 1 && argument[0]->kind < NodeKind::word && argument[0]->kind != NodeKind::call;
  if (!is_single) return read_stream(argument);
  const Node& node = *argument[0];
  if (node.kind == NodeKind::name || node.kind == NodeKind::index) {
    push_reference(find_slot(context_, node));
  } else {
    evaluate_into(context_, node, push());
  }
}

void ArgumentSlots::read_stream(const grammar::Argument& argument) {
  // Several actuals without commas between them, a colour of several words, a block, or whatever a macro yields.
  ElementStream stream(context_, argument, argument.empty() ? SourceSpan{} : argument.front()->span);
  while (!stream.peek().is(ElementKind::end)) {
    const Element next = stream.peek();
    if (next.is(ElementKind::value) && next.word != grammar::kNoSymbol) {
      // Bound before the stream goes on: what follows may end the scope that the name is of.
      stream.drop();
      push_reference(find_slot(context_, *next.node));
      if (stream.peek().is(ElementKind::word)) {
        Value first = context_.argument_slots.back()->value;
        context_.scopes.slots().release(context_.argument_slots.back());
        context_.argument_slots.pop_back();
        push() = read_rvalue_after(stream, std::move(first));
      }
    } else {
      push() = read_rvalue(stream);
    }
    stream.accept_comma();
  }
}

}  // namespace isl::interpreter
