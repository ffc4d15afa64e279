#include "interpreter/macro_calls.h"

#include "grammar/suggest.h"
#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/functions/functions.h"
#include "interpreter/readers/words/rvalue.h"

#include <fmt/format.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace isl::interpreter {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;

namespace {

// Mistakes are handled out of line, because every call goes through the caller.

[[noreturn]] [[gnu::noinline]] void fail_count(Context& context, const grammar::Call& call,
                                               const grammar::Macro& definition, std::size_t found) {
  const std::size_t wanted = definition.parameters.size();
  std::string parameters;
  for (const grammar::Symbol parameter : definition.parameters) {
    if (!parameters.empty()) parameters += ", ";
    parameters += context.text(parameter);
  }
  context.fail(call.span,
               fmt::format("macro `{}` takes {} argument{}, found {}", context.text(definition.name), wanted,
                           wanted == 1 ? "" : "s", found),
               fmt::format("it is declared as `{}({})`", context.text(definition.name), parameters));
}

/// The intended built-in function: `minextent` is `min_extent`.
std::string suggest_function(Context& context, grammar::Symbol name) {
  std::vector<std::string_view> functions;
  for (std::uint32_t i = 0; i < grammar::word::kReservedCount; ++i) {
    const grammar::Symbol word{i};
    if (context.symbols.word_class(word) == grammar::WordClass::function) functions.push_back(context.text(word));
  }
  const auto nearest = grammar::closest(context.text(name), functions);
  return nearest ? fmt::format("did you mean `{}`?", *nearest) : std::string();
}

[[noreturn]] [[gnu::noinline]] void fail_undeclared_callee(Context& context, SourceSpan span, grammar::Symbol name) {
  std::string hint = context.suggest_declared(name);
  if (hint.empty()) hint = suggest_function(context, name);
  context.fail(span, fmt::format("undeclared macro or function `{}`", context.text(name)), std::move(hint));
}

[[noreturn]] [[gnu::noinline]] void fail_uncallable(Context& context, SourceSpan span, const Value& value) {
  context.fail(span, fmt::format("{} cannot be called", describe(value)));
}

/// The actual arguments of one call, in the slots that its parameters will be bound to.
class ArgumentSlots {
 public:
  ArgumentSlots(Context& context, const grammar::Call& call, const grammar::Macro& definition);
  ~ArgumentSlots() { release(); }
  ArgumentSlots(const ArgumentSlots&) = delete;
  ArgumentSlots& operator=(const ArgumentSlots&) = delete;

  /// Binds them to the parameters in the scope that was just entered; the list is empty then.
  void bind_to(std::span<const grammar::Symbol> parameters);

 private:
  void read(const grammar::Argument& argument);
  void read_sum(const Node& sum);
  void read_stream(const grammar::Argument& argument);
  /// A new slot's value, for the caller to set.
  [[nodiscard]] Value& push();
  void push_reference(Slot& slot);
  void release();

  Context& context_;
  std::size_t begin_;  ///< the slots lie on Context::argument_slots, which nested calls share
};

ArgumentSlots::ArgumentSlots(Context& context, const grammar::Call& call, const grammar::Macro& definition)
    : context_(context), begin_(context.argument_slots.size()) {
  try {
    for (const grammar::Argument& argument : call.arguments) read(argument);
    const std::size_t found = context.argument_slots.size() - begin_;
    if (found != definition.parameters.size()) fail_count(context, call, definition, found);
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
  } else if (node.kind == NodeKind::binary) {
    read_sum(node);
  } else {
    evaluate_into(context_, node, push());
  }
}

void ArgumentSlots::read_sum(const Node& sum) {
  const Node* const outer = std::exchange(context_.argument, &sum);
  try {
    evaluate_into(context_, sum, push());
    context_.argument = outer;
  } catch (const TermsApart& apart) {
    context_.argument = outer;
    context_.argument_slots.back()->value = apart.left;
    push() = rest_of_terms(context_, sum, apart);
  } catch (...) {
    context_.argument = outer;
    throw;
  }
}

[[gnu::noinline]] void ArgumentSlots::read_stream(const grammar::Argument& argument) {
  // Several actuals without commas between them, a colour of several words, a block, or all that a macro yields.
  ElementStream stream(context_, argument, argument.empty() ? SourceSpan{} : argument.front()->span);
  while (!stream.peek().is(ElementKind::end)) {
    const Element next = stream.peek();
    if (next.is(ElementKind::value) && next.word != grammar::kNoSymbol) {
      // Bound before the stream goes on: the next elements may end the scope of the name.
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

}  // namespace

const Value& called(Context& context, const grammar::Call& call) {
  if (call.callee->kind == NodeKind::name) {
    const grammar::Symbol name = as<grammar::Name>(*call.callee).name;
    const Slot* const slot = context.scopes.find(name);
    if (!slot) fail_undeclared_callee(context, call.callee->span, name);
    if (slot->value.kind() == ValueKind::macro) return slot->value;
  }
  const Value& value = find_slot(context, *call.callee).value;
  if (value.kind() == ValueKind::poison) throw Failed{};
  if (value.kind() != ValueKind::macro && !is_callable(value)) fail_uncallable(context, call.span, value);
  return value;
}

void push_macro(Context& context, const grammar::Call& call, const MacroValue& macro) {
  const grammar::Macro& definition = macro.definition;
  const grammar::Unit& unit = macro.unit;
  const std::uint32_t origin_name = macro.origin_name;
  context.count_turn(call.span);
  ArgumentSlots arguments(context, call, definition);
  context.push_call(Frame::Kind::macro, definition.body, call, unit, origin_name);
  context.scopes.enter();
  arguments.bind_to(definition.parameters);
}

}  // namespace isl::interpreter
