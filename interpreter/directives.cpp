#include "interpreter/directives.h"

#include "interpreter/arrays.h"
#include "interpreter/control.h"
#include "interpreter/deprecated_names.h"
#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/files.h"
#include "interpreter/functions/functions.h"
#include "interpreter/macro_calls.h"
#include "interpreter/operators.h"
#include "interpreter/readers/words/rvalue.h"
#include "interpreter/readers/world/scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;

/// A directive's own semicolon is the next item of the list that holds it.
bool skip_semicolon(Context& context) {
  Frame& frame = context.frames.back();
  if (frame.next == frame.end || (*frame.next)->kind != NodeKind::semicolon) return false;
  ++frame.next;
  return true;
}

/// True if the item can be the first of a statement. A name is excluded, because it may stand anywhere.
bool begins_statement(const Node& item) {
  const bool is_directive = item.kind >= NodeKind::declare && item.kind != NodeKind::error;
  const bool is_object = item.kind == NodeKind::block && grammar::is_reserved(as<grammar::Block>(item).word);
  return is_directive || is_object || item.kind == NodeKind::call;
}

/// The rest of a statement with a mistake, such as the braces in `= dictionary { … };`, must not cause a second error.
/// If another statement begins before a semicolon, the first one has none, and nothing is skipped.
void skip_rest(Context& context) {
  if (context.abandoned_blocks > 0) return skip_abandoned(context);
  Frame& frame = context.frames.back();
  const auto* const stop = std::find_if(frame.next, frame.end, [](const Node* item) {
    return item->kind == NodeKind::semicolon || begins_statement(*item);
  });
  if (stop != frame.end && (*stop)->kind == NodeKind::semicolon) frame.next = stop + 1;
}

// ---- #declare -------------------------------------------------------------------------------------------------------

Value read_to_end(ElementStream& stream, bool& terminated) {
  Context& context = stream.context();
  if (stream.peek().is(ElementKind::end)) context.fail(stream.span(), "expected a value to declare, found none");
  Value value = read_declared(stream);
  terminated = stream.accept(ElementKind::semicolon);
  const Element& next = stream.peek();
  if (!next.is(ElementKind::end)) context.fail(next.span, "expected one value to declare, found a second");
  return value;
}

/// `#declare T = Macro() texture { … }`: over the texture of a macro lie those that are the next items of the list that
/// holds the declaration.
Value with_following_layers(Context& context, Value value) {
  Frame& frame = context.frames.back();
  const auto* const end = std::find_if_not(frame.next, frame.end, [](const Node* item) {
    return item->kind == NodeKind::block && as<grammar::Block>(*item).word == grammar::word::kw_texture;
  });
  const grammar::Items layers(frame.next, end);
  if (layers.empty()) return value;
  frame.next = end;
  ElementStream stream(context, layers, layers.front()->span);
  return with_layers(stream, std::move(value));
}

/// The value of a declaration; `terminated` if a macro's or branch's own semicolon ended it.
void evaluate_declared(Context& context, const grammar::Declare& node, Value& value, bool& terminated) {
  const Node* const only = node.value.size() == 1 ? node.value[0] : nullptr;
  if (only && (only->kind < NodeKind::word || only->kind == NodeKind::function) && only->kind != NodeKind::call)
    return evaluate_into(context, *only, value);
  if (only && only->kind == NodeKind::call) {
    const auto& call = as<grammar::Call>(*only);
    const Value& callee = called(context, call);
    if (is_callable(callee)) {
      value = call_function(context, call, callee);
    } else {
      // A lone macro call is followed without a frame for the list that holds it.
      ElementStream stream(context, call, callee.as<MacroValue>());
      value = read_to_end(stream, terminated);
    }
    if (value.kind() == ValueKind::texture && !terminated) value = with_following_layers(context, std::move(value));
  } else {
    if (node.value.size() > 1 && node.value[0]->kind == NodeKind::declare) {
      context.warn(node.target->span, "the value of this declaration stands behind other declarations",
                   "write the value directly after `=`");
    }
    ElementStream stream(context, node.value, node.span);
    value = read_to_end(stream, terminated);
  }
}

Slot& declared_slot(Context& context, const grammar::Declare& node) {
  if (node.target->kind == NodeKind::index) return find_slot(context, *node.target);
  if (node.target->kind != NodeKind::name) throw Failed{};
  const grammar::Symbol name = as<grammar::Name>(*node.target).name;
  return node.local ? context.scopes.local(name) : context.scopes.declare(name);
}

/// The slot to write to, if the value is a function or the name is deprecated.
[[gnu::noinline]] Slot& guarded_slot(Context& context, const grammar::Declare& node, Slot& declared) {
  Slot& slot = used(context, declared, node.target->span);
  if (slot.value.kind() == ValueKind::function) {
    context.fail(node.target->span, "a function cannot be declared again", "`#undef` it first");
  }
  return slot;
}

[[gnu::noinline]] void declare(Context& context, const grammar::Declare& node) {
  try {
    bool terminated = false;
    Value value;
    evaluate_declared(context, node, value, terminated);
    if (!terminated) {
      terminated = skip_semicolon(context);
    } else if (value.is_numeric()) {
      // The macro's own semicolon was the first of the two that a number's declaration may have (spare_semicolons.h).
      skip_semicolon(context);
    }
    if (!terminated && value.is_numeric() && context.version.number() >= 3.5) [[unlikely]] {
      context.error({node.span.end, node.span.end},
                    fmt::format("expected `;` after the declaration of {}", describe(value)));
    }
    Slot* target = &declared_slot(context, node);
    if (target->value.kind() >= ValueKind::function) [[unlikely]]
      target = &guarded_slot(context, node, *target);
    Slot& slot = *target;
    if (value.kind() == ValueKind::array) [[unlikely]] {
      if (node.target->kind == NodeKind::index) check_array_nesting(context, value, node.span);
      // Assignment copies an array, as in POV-Ray; all other values are immutable and shared.
      context.check_memory(node.span, value.as<ArrayValue>().bytes_of_copy());
      slot.value = Value(ValueKind::array, value.as<ArrayValue>().copy());
    } else {
      slot.value = std::move(value);
    }
  } catch (const Failed&) {
    // The name is declared all the same, so that its uses cause no further errors.
    if (node.target->kind == NodeKind::name) {
      Slot& slot = *without_wrapper(&declared_slot(context, node));
      if (slot.value.kind() != ValueKind::function) slot.value = Value::poison();
    }
    skip_rest(context);
  }
}

[[gnu::noinline]] void declare_deprecated(Context& context, const grammar::Declare& node) {
  if (node.target->kind != NodeKind::name) {
    context.warn(node.target->span, "`deprecated` has no effect on an element of an array");
    return declare(context, node);
  }
  const Slot* const before = context.scopes.find(as<grammar::Name>(*node.target).name);
  declare(context, node);
  // As in POV-Ray, names declared earlier keep their values.
  Slot& slot = declared_slot(context, node);
  if (&slot != before) deprecate(context, node, slot);
}

[[gnu::noinline]] void undefine(Context& context, const grammar::Undef& node) {
  if (node.target->kind == NodeKind::index) {
    if (Slot* slot = find_slot_if_declared(context, *node.target)) slot->value = Value();
  } else if (node.target->kind == NodeKind::name) {
    const grammar::Symbol name = as<grammar::Name>(*node.target).name;
    static_cast<void>(used(context, context.scopes.find(name), node.target->span));
    context.scopes.undef(name);
  }
  skip_semicolon(context);
}

[[gnu::noinline]] void define_macro(Context& context, const grammar::Macro& node) {
  const std::uint32_t name = context.origins.keep_name(std::string(context.text(node.name)));
  context.scopes.global(node.name).value =
      Value(ValueKind::macro, make_shared_value<MacroValue>(node, context.current_unit(), name));
}

// ---- Files ----------------------------------------------------------------------------------------------------------

[[gnu::noinline]] void include(Context& context, const grammar::Include& node) {
  Value keep;
  // In a file's name, a backslash is an ordinary character.
  const std::string_view name = node.path->kind == NodeKind::string
                                    ? as<grammar::String>(*node.path).raw
                                    : std::string_view(evaluate_string(context, *node.path, keep).text);
  skip_semicolon(context);
  std::size_t depth = 0;
  for (const Frame& frame : context.frames) depth += frame.kind == Frame::Kind::include;
  if (depth >= context.options.limits.max_include_depth) {
    context.stop(node.span,
                 fmt::format("more than {} files include one another", context.options.limits.max_include_depth),
                 "`--max-include-depth` raises the limit");
  }
  const grammar::Unit* unit = context.loader.load_include(name, node.path->span, context.current_unit());
  if (!unit) throw Stopped{};
  const std::uint32_t file = context.origins.keep_name(std::string(name));
  context.push_call(Frame::Kind::include, unit->items, node, *unit, file);
  context.scopes.enter();
}

// ---- Messages and the rest ------------------------------------------------------------------------------------------

[[gnu::noinline]] void speak(Context& context, const grammar::Message& node) {
  Value keep;
  const std::string& text = evaluate_string(context, *node.text, keep).text;
  skip_semicolon(context);
  switch (node.level) {
    case grammar::MessageKind::debug:
      context.count_debug(node.span, text.size());
      if (context.options.print_debug) context.options.print_debug(text);
      break;
    case grammar::MessageKind::warning: context.warn(node.span, text); break;
    case grammar::MessageKind::error: context.stop(node.span, text);
  }
}

[[gnu::noinline]] void set_version(Context& context, const grammar::Version& node) {
  const double version = evaluate_number(context, *node.value);
  skip_semicolon(context);
  context.version.state(version);
  if (context.version.number() > LanguageVersion::kNewest) {
    context.warn(node.span,
                 fmt::format("version {:g} of the language is unknown; the scene is read as {:g}",
                             context.version.number(), LanguageVersion::kNewest),
                 "dictionaries, mixed arrays, optional parameters, `lemon`, `potential`, `polarity` and `user_defined` "
                 "came with 3.8");
  }
}

}  // namespace

// The functions that it calls stay out of line: it runs for every directive, and is then only a jump.
void execute(Context& context, const Node& node) {
  switch (node.kind) {
    case NodeKind::if_:
    case NodeKind::ifdef:
    case NodeKind::while_:
    case NodeKind::for_:
    case NodeKind::switch_: return start_control(context, node);
    case NodeKind::declare: return declare(context, as<grammar::Declare>(node));
    case NodeKind::declare_deprecated: return declare_deprecated(context, as<grammar::Declare>(node));
    case NodeKind::undef: return undefine(context, as<grammar::Undef>(node));
    case NodeKind::macro: return define_macro(context, as<grammar::Macro>(node));
    case NodeKind::include: return include(context, as<grammar::Include>(node));
    case NodeKind::version: return set_version(context, as<grammar::Version>(node));
    case NodeKind::default_: return read_default(context, as<grammar::Default>(node).items, node.span);
    case NodeKind::message: return speak(context, as<grammar::Message>(node));
    case NodeKind::fopen: return open_file(context, as<grammar::Fopen>(node));
    case NodeKind::fclose: return close_file(context, as<grammar::Fclose>(node));
    case NodeKind::read: return read_file(context, as<grammar::Read>(node));
    case NodeKind::write: return write_file(context, as<grammar::Write>(node));
    default: ISL_CHECK(false, "node kind {} is no directive", static_cast<int>(node.kind));
  }
}

}  // namespace isl::interpreter
