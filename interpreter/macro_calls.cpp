#include "interpreter/macro_calls.h"

#include "grammar/suggest.h"
#include "interpreter/deprecated_names.h"
#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/functions/functions.h"
#include "interpreter/newer_words.h"
#include "interpreter/operators.h"
#include "interpreter/places.h"
#include "interpreter/readers/words/rvalue.h"
#include "interpreter/routines/routines.h"

#include <fmt/format.h>

#include <algorithm>
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

/// "it is declared as `M(A, optional B)`".
std::string declaration_of(Context& context, const grammar::Macro& definition) {
  std::string parameters;
  for (const grammar::Parameter& parameter : definition.parameters) {
    if (!parameters.empty()) parameters += ", ";
    if (parameter.optional) parameters += "optional ";
    parameters += context.text(parameter.name);
  }
  return fmt::format("it is declared as `{}({})`", context.text(definition.name), parameters);
}

[[noreturn]] [[gnu::noinline]] void fail_count(Context& context, const grammar::Call& call,
                                               const grammar::Macro& definition, std::size_t found) {
  const std::size_t wanted = definition.parameters.size();
  const auto is_optional = [](const grammar::Parameter& parameter) { return parameter.optional; };
  const auto needed = wanted - static_cast<std::size_t>(std::ranges::count_if(definition.parameters, is_optional));
  if (found >= needed && found < wanted) {
    context.fail(call.span,
                 fmt::format("macro `{}` takes {} arguments, found {}; only the last ones can be left out with their "
                             "commas",
                             context.text(definition.name), wanted, found),
                 fmt::format("keep the comma of an argument before others: `{}(, …)`; {}",
                             context.text(definition.name), declaration_of(context, definition)));
  }
  context.fail(call.span,
               fmt::format("macro `{}` takes {}{} argument{}, found {}", context.text(definition.name),
                           needed < wanted ? fmt::format("{} to ", needed) : "", wanted, wanted == 1 ? "" : "s", found),
               declaration_of(context, definition));
}

[[noreturn]] [[gnu::noinline]] void fail_omitted(Context& context, const grammar::Call& call,
                                                 const grammar::Macro& definition, std::size_t argument) {
  if (argument >= definition.parameters.size()) fail_count(context, call, definition, argument + 1);
  context.fail(call.span,
               fmt::format("macro `{}` needs its argument `{}`, found none before a comma",
                           context.text(definition.name), context.text(definition.parameters[argument].name)),
               declaration_of(context, definition));
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
  ~ArgumentSlots() {
    if (context_.argument_slots.size() > begin_) [[unlikely]]
      release();
  }
  ArgumentSlots(const ArgumentSlots&) = delete;
  ArgumentSlots& operator=(const ArgumentSlots&) = delete;

  /// Binds them to the parameters in the scope that was just entered; the list is empty then.
  void bind_to(std::span<const grammar::Parameter> parameters);

 private:
  void read(const grammar::Argument& argument);
  void read_sum(const Node& sum);
  /// The argument is a place other than a declared name.
  void read_place(const Node& node);
  /// True if the next argument may be left out.
  [[nodiscard]] bool is_optional_next() const;
  void push_omitted() { context_.argument_slots.push_back(nullptr); }
  /// Leaves out the last arguments.
  void complete();
  void read_stream(const grammar::Argument& argument);
  /// A new slot's value, for the caller to set.
  [[nodiscard]] Value& push();
  void push_reference(Slot& slot);
  void release();

  Context& context_;
  const grammar::Call& call_;
  const grammar::Macro& definition_;
  std::size_t begin_;  ///< the slots lie on Context::argument_slots, which nested calls share
};

ArgumentSlots::ArgumentSlots(Context& context, const grammar::Call& call, const grammar::Macro& definition)
    : context_(context), call_(call), definition_(definition), begin_(context.argument_slots.size()) {
  try {
    for (const grammar::Argument& argument : call.arguments) read(argument);
    if (context.argument_slots.size() - begin_ != definition.parameters.size()) [[unlikely]]
      complete();
  } catch (...) {
    release();
    throw;
  }
}

[[gnu::noinline]] void ArgumentSlots::complete() {
  const std::span<const grammar::Parameter> parameters = definition_.parameters;
  const std::size_t found = context_.argument_slots.size() - begin_;
  const auto is_optional = [](const grammar::Parameter& parameter) { return parameter.optional; };
  const bool can_end = found < parameters.size() && std::ranges::all_of(parameters.subspan(found), is_optional);
  if (!can_end) fail_count(context_, call_, definition_, found);
  while (context_.argument_slots.size() - begin_ < parameters.size()) push_omitted();
}

bool ArgumentSlots::is_optional_next() const {
  const std::size_t next = context_.argument_slots.size() - begin_;
  return next < definition_.parameters.size() && definition_.parameters[next].optional;
}

void ArgumentSlots::bind_to(std::span<const grammar::Parameter> parameters) {
  auto& slots = context_.argument_slots;
  const auto begin = slots.begin() + static_cast<std::ptrdiff_t>(begin_);
  auto slot = begin;
  for (const grammar::Parameter& parameter : parameters) {
    if (*slot != nullptr) context_.scopes.bind(parameter.name, *slot);
    ++slot;
  }
  slots.erase(begin, slots.end());
}

void ArgumentSlots::release() {
  auto& slots = context_.argument_slots;
  for (; slots.size() > begin_; slots.pop_back()) {
    if (slots.back() != nullptr) context_.scopes.slots().release(slots.back());
  }
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
  if (node.kind == NodeKind::name) {
    Slot* const slot = context_.scopes.find(as<grammar::Name>(node).name);
    if (slot == nullptr) [[unlikely]]
      return read_place(node);
    push_reference(used(context_, *slot, node.span));
  } else if (grammar::is_place(node)) {
    read_place(node);
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

/// A place other than a declared name. One that is not declared leaves out an optional parameter.
[[gnu::noinline]] void ArgumentSlots::read_place(const Node& node) {
  const bool is_word = node.kind == NodeKind::name && is_newer_value(as<grammar::Name>(node).name);
  if (is_word || (node.kind == NodeKind::dot && !is_field(context_, node)))
    return evaluate_into(context_, node, push());
  Slot* const slot = find_slot_if_declared(context_, node);
  const bool is_omitted = is_optional_next() && (!slot || slot->value.kind() == ValueKind::none);
  if (is_omitted) return push_omitted();
  push_reference(slot ? *slot : find_slot(context_, node));
}

[[gnu::noinline]] void ArgumentSlots::read_stream(const grammar::Argument& argument) {
  // Several actuals without commas between them, a colour of several words, a block, or all that a macro yields.
  if (argument.empty()) {
    if (!is_optional_next()) fail_omitted(context_, call_, definition_, context_.argument_slots.size() - begin_);
    return push_omitted();
  }
  ElementStream stream(context_, argument, argument.front()->span);
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

/// A macro's frame and scope, while its body runs on the native stack.
class MacroFrame {
 public:
  MacroFrame(Context& context, const grammar::Call& call, const MacroValue& macro)
      : context_(context), nesting_(context, call.span, kStreamUnits) {
    push_macro(context, call, macro);
  }
  ~MacroFrame() { context_.pop(); }
  MacroFrame(const MacroFrame&) = delete;
  MacroFrame& operator=(const MacroFrame&) = delete;

 private:
  Context& context_;
  NestingGuard nesting_;
};

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

void call_routine(Context& context, const grammar::Call& call, const MacroValue& macro, const Routine& routine) {
  Value none;
  const MacroFrame frame(context, call, macro);
  run_body(context, routine, none);
}

void call_routine(Context& context, const grammar::Call& call, const MacroValue& macro, const Routine& routine,
                  const char* without_value, Value& result) {
  const MacroFrame frame(context, call, macro);
  if (!run_body(context, routine, result)) context.fail(call.span, without_value);
}

}  // namespace isl::interpreter
