#include "interpreter/directives.h"

#include "interpreter/control.h"
#include "interpreter/deprecated_names.h"
#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/files.h"
#include "interpreter/functions/functions.h"
#include "interpreter/macro_calls.h"
#include "interpreter/newer_words.h"
#include "interpreter/operators.h"
#include "interpreter/places.h"
#include "interpreter/readers/words/rvalue.h"
#include "interpreter/readers/world/scene.h"
#include "interpreter/routines/routine.h"
#include "interpreter/routines/routines.h"
#include "interpreter/statement_ends.h"
#include "interpreter/tuples.h"

#include <fmt/format.h>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;

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
      const auto& macro = callee.as<MacroValue>();
      const Routine* const routine = routine_of(context, macro);
      if (routine && routine->yields)
        return call_routine(context, call, macro, *routine, "expected a value to declare, found none", value);
      ElementStream stream(context, call, macro);
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
  if (node.target->kind != NodeKind::name) return slot_to_write(context, *node.target, node.local);
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

/// Assignment copies an array or a dictionary, as in POV-Ray; all other values are immutable and shared.
[[gnu::noinline]] void set_container(Context& context, const grammar::Declare& node, Slot& slot, const Value& value) {
  if (node.target->kind != NodeKind::name) check_container_depth(context, value, node.span);
  context.check_memory(node.span, bytes_of_copy(value));
  slot.value = copy_of_container(value);
}

/// In a routine the declaration's semicolon is known to follow, and is passed by the routine.
enum class Semicolon { next_item, passed };

[[gnu::noinline]] void declare(Context& context, const grammar::Declare& node,
                               Semicolon semicolon = Semicolon::next_item) {
  try {
    bool terminated = false;
    Value value;
    evaluate_declared(context, node, value, terminated);
    if (semicolon == Semicolon::passed) {
      terminated = true;
    } else if (!terminated) {
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
    if (value.is_number()) {
      slot.value.set_number(value.number());
    } else if (is_container(value)) [[unlikely]] {
      set_container(context, node, slot, value);
    } else {
      slot.value = std::move(value);
    }
  } catch (const Failed&) {
    // The name is declared all the same, so that its uses cause no further errors.
    if (node.target->kind == NodeKind::name) {
      Slot& slot = *without_wrapper(&declared_slot(context, node));
      if (slot.value.kind() != ValueKind::function) slot.value = Value::poison();
    }
    if (semicolon == Semicolon::next_item) skip_rest(context);
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

/// A word of POV-Ray 3.8: the name of a variable in an older scene.
[[gnu::noinline]] void declare_newer_word(Context& context, const grammar::Declare& node) {
  try {
    check_newer_name(context, as<grammar::Name>(*node.target).name, node.target->span);
  } catch (const Failed&) {
    return skip_rest(context);
  }
  declare(context, node);
}

[[gnu::noinline]] void undefine_place(Context& context, const grammar::Undef& node) {
  undefine(context, *node.target);
  skip_semicolon(context);
}

[[gnu::noinline]] void define_macro(Context& context, const grammar::Macro& node) {
  check_newer_name(context, node.name, node.name_span);
  for (const grammar::Parameter& parameter : node.parameters) {
    check_newer_name(context, parameter.name, node.name_span);
    if (parameter.optional) note_newer_word(context, grammar::newer_word::kw_optional, node.name_span);
  }
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
  follow_version(context);
  const double stated = context.version.number();
  if (stated >= LanguageVersion::kWithNewerWords && stated < LanguageVersion::kNewest)
    context.warn(node.span, fmt::format("version {:g} of the language became {:g}", stated, LanguageVersion::kNewest),
                 fmt::format("write `#version {:g};`", LanguageVersion::kNewest));
  if (context.version.number() > LanguageVersion::kNewest) {
    context.warn(node.span, fmt::format("version {:g} of the language is unknown; the scene is read as {:g}",
                                        context.version.number(), LanguageVersion::kNewest));
  }
}

}  // namespace

void declare_in_routine(Context& context, const grammar::Declare& node) { declare(context, node, Semicolon::passed); }

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
    case NodeKind::declare_newer_word: return declare_newer_word(context, as<grammar::Declare>(node));
    case NodeKind::declare_tuple: return declare_tuple(context, as<grammar::DeclareTuple>(node));
    case NodeKind::undef: return undefine_place(context, as<grammar::Undef>(node));
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
