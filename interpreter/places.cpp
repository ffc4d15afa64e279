#include "interpreter/places.h"

#include "grammar/newer_words.h"
#include "grammar/suggest.h"
#include "interpreter/deprecated_names.h"
#include "interpreter/expressions.h"
#include "interpreter/newer_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;
using grammar::Symbol;

enum class Purpose : std::uint8_t {
  use,    ///< what is not declared is an error
  ask,    ///< it is null
  write,  ///< the last part is made
};

/// One `[index]` or `.Key` of a path.
struct Step {
  const Node* node;
  Value subscript;  ///< of an index
};

// ---- Names ----------------------------------------------------------------------------------------------------------

Slot* scoped_slot(Context& context, const grammar::ScopedName& node) {
  const bool is_local = node.scope == grammar::ScopeName::local;
  note_newer_word(context, is_local ? grammar::word::kw_local : grammar::newer_word::kw_global, node.span);
  return is_local ? context.scopes.find_local(node.name) : context.scopes.find_global(node.name);
}

[[noreturn]] void fail_unscoped(Context& context, const grammar::ScopedName& node) {
  const bool is_local = node.scope == grammar::ScopeName::local;
  context.fail(node.span, fmt::format("`{}` is not declared in the {} scope", context.text(node.name),
                                      is_local ? "innermost" : "outermost"));
}

Slot* root_slot(Context& context, const Node& root, Purpose purpose) {
  if (root.kind == NodeKind::name) {
    const Symbol name = as<grammar::Name>(root).name;
    Slot* const slot = context.scopes.find(name);
    if (purpose == Purpose::ask) return without_wrapper(slot);
    if (slot) return &used(context, *slot, root.span);
    fail_undeclared(context, root.span, name);
  }
  if (root.kind == NodeKind::scoped_name) {
    Slot* const slot = scoped_slot(context, as<grammar::ScopedName>(root));
    if (purpose == Purpose::ask) return without_wrapper(slot);
    if (slot) return &used(context, *slot, root.span);
    fail_unscoped(context, as<grammar::ScopedName>(root));
  }
  if (root.kind == NodeKind::error) context.meet(as<grammar::Error>(root));
  if (purpose == Purpose::ask && root.kind != NodeKind::error) return nullptr;
  throw Failed{};
}

// ---- Arrays ---------------------------------------------------------------------------------------------------------

[[noreturn]] [[gnu::noinline]] void fail_outside(Context& context, const Node& node, double index, std::size_t size) {
  if (size == 0) context.fail(node.span, "the array has no elements yet");
  context.fail(node.span, fmt::format("expected an index from 0 to {}, found {:g}", size - 1, index));
}

[[gnu::noinline]] std::size_t grown_to(Context& context, const Node& node, ArrayValue& array, double index) {
  constexpr double kMost = 1e12;  // more than any machine holds
  if (!(array.grows && index >= 0 && index < kMost)) fail_outside(context, node, index, array.elements.size());
  const auto place = static_cast<std::size_t>(index);
  context.check_memory(node.span, ArrayElements::bytes_of(place + 1 - array.elements.size()));
  array.grow(place + 1);
  return place;
}

/// The place of the element with the index that the subscript `node` has, in the dimension of this `size`.
std::size_t place_of(Context& context, const Node& node, double value, ArrayValue& array, std::size_t size) {
  const double index = value + kTolerance;
  if (!(index >= 0 && index < static_cast<double>(size))) [[unlikely]]
    return grown_to(context, node, array, index);
  return static_cast<std::size_t>(index);
}

[[gnu::noinline]] Slot& new_slot(Context& context, SourceSpan span, ArrayValue& array, std::size_t place) {
  context.check_memory(span, array.elements.bytes_of_slot());
  return array.elements.slot(place);
}

Slot* slot_of(Context& context, SourceSpan span, ArrayValue& array, std::size_t place) {
  return array.elements.has_slot(place) ? &array.elements.slot(place) : &new_slot(context, span, array, place);
}

/// The one-dimensional array that the slot holds, or null.
ArrayValue* list_in(const Slot* slot) {
  if (!slot || slot->value.kind() != ValueKind::array) return nullptr;
  ArrayValue& array = slot->value.as<ArrayValue>();
  return array.dimensions.size() == 1 ? &array : nullptr;
}

double index_of(Context& context, const Step& step) {
  const Node& subscript = *as<grammar::Index>(*step.node).subscript;
  if (!step.subscript.is_number())
    context.fail(subscript.span,
                 fmt::format("expected a number as index of an array, found {}", describe(step.subscript)));
  return step.subscript.number();
}

/// The element that the first steps of the path lead to; moves `step` behind them.
Slot* element_at(Context& context, ArrayValue& array, const std::vector<Step>& path, std::size_t& step) {
  const std::size_t begin = step;
  std::size_t place = 0;
  for (std::size_t dimension = 0; dimension < array.dimensions.size(); ++dimension) {
    if (step == path.size() || path[step].node->kind != NodeKind::index) {
      context.fail(path[step - 1].node->span,
                   fmt::format("the array has {} dimensions, found {} index{}", array.dimensions.size(), step - begin,
                               step - begin == 1 ? "" : "es"));
    }
    const Node& subscript = *as<grammar::Index>(*path[step].node).subscript;
    const std::size_t size = array.dimensions[dimension];
    place = place * size + place_of(context, subscript, index_of(context, path[step]), array, size);
    ++step;
  }
  return slot_of(context, path[step - 1].node->span, array, place);
}

// ---- Dictionaries ---------------------------------------------------------------------------------------------------

std::string key_of(Context& context, const Step& step) {
  if (step.node->kind == NodeKind::dot) return std::string(context.text(as<grammar::Dot>(*step.node).item));
  if (step.subscript.kind() == ValueKind::string) return step.subscript.as<StringValue>().text;
  context.fail(as<grammar::Index>(*step.node).subscript->span,
               fmt::format("expected a string as key of a dictionary, found {}", describe(step.subscript)));
}

[[noreturn]] void fail_missing(Context& context, SourceSpan span, const DictionaryValue& dictionary,
                               std::string_view key) {
  std::vector<std::string_view> keys;
  for (const auto& [other, slot] : dictionary.fields) keys.emplace_back(other);
  const auto nearest = grammar::closest(key, keys);
  context.fail(
      span, fmt::format("the dictionary has no value `{}`", key),
      nearest ? fmt::format("did you mean `{}`?", *nearest) : "`#declare` adds it; `#ifdef` tells whether it is there");
}

Slot* field_at(Context& context, DictionaryValue& dictionary, const Step& step, Purpose purpose) {
  const std::string key = key_of(context, step);
  Slot* const slot = dictionary.find(key);
  if (slot || purpose == Purpose::ask) return slot;
  if (purpose == Purpose::use) fail_missing(context, step.node->span, dictionary, key);
  context.check_memory(step.node->span, DictionaryValue::bytes_of_field(key) + kSlotBytes);
  return &dictionary.add(key);
}

// ---- Paths ----------------------------------------------------------------------------------------------------------

[[noreturn]] void fail_no_container(Context& context, const Node& base, const Node& step, const Value& found) {
  const bool is_index = step.kind == NodeKind::index;
  context.fail(base.span, fmt::format("expected {} before `{}`, found {}", is_index ? "an array" : "a dictionary",
                                      is_index ? "[" : ".", describe(found)));
}

Slot* walk(Context& context, const Node& root, Slot* slot, const std::vector<Step>& path, Purpose purpose) {
  for (std::size_t step = 0; step < path.size();) {
    // Kept, because a mistake in an index must not end the container under way.
    const Value container = slot->value;
    if (container.kind() == ValueKind::poison) throw Failed{};
    if (container.kind() == ValueKind::array && path[step].node->kind == NodeKind::index) {
      slot = element_at(context, container.as<ArrayValue>(), path, step);
    } else if (container.kind() == ValueKind::dictionary) {
      const bool is_last = step + 1 == path.size();
      const Purpose here = !is_last && purpose == Purpose::write ? Purpose::use : purpose;
      slot = field_at(context, container.as<DictionaryValue>(), path[step], here);
      ++step;
    } else if (purpose == Purpose::ask) {
      return nullptr;
    } else {
      fail_no_container(context, step == 0 ? root : *path[step - 1].node, *path[step].node, container);
    }
    if (!slot) return nullptr;
  }
  return slot;
}

// A subscript may call a macro that undeclares the container, or declares another by its name. So subscripts are
// evaluated first, and the container is looked up after them.
Slot* find_on_path(Context& context, const Node& place, Purpose purpose) {
  std::vector<Step> path;
  const Node* node = &place;
  while (node->kind == NodeKind::index || node->kind == NodeKind::dot) {
    path.push_back({node, {}});
    node = node->kind == NodeKind::index ? as<grammar::Index>(*node).base : as<grammar::Dot>(*node).base;
  }
  std::ranges::reverse(path);
  const Purpose for_root = purpose == Purpose::ask ? Purpose::ask : Purpose::use;
  const Slot* const before = root_slot(context, *node, for_root);
  if (!before) return nullptr;
  if (is_container(before->value)) {
    for (Step& step : path) {
      if (step.node->kind == NodeKind::index)
        step.subscript = evaluate(context, *as<grammar::Index>(*step.node).subscript);
    }
  }
  Slot* const slot = root_slot(context, *node, for_root);
  return slot ? walk(context, *node, slot, path, purpose) : nullptr;
}

struct ListElement {
  ArrayValue* list;
  std::size_t place;
};

/// The common case: A[i] of one dimension. The list is null if the place is none.
ListElement element_of_list(Context& context, const Node& place) {
  if (place.kind != NodeKind::index) return {};
  const auto& node = as<grammar::Index>(place);
  if (node.base->kind != NodeKind::name) return {};
  const Symbol name = as<grammar::Name>(*node.base).name;
  if (!list_in(context.scopes.find(name))) return {};
  const double index = evaluate_number(context, *node.subscript);
  ArrayValue* const list = list_in(context.scopes.find(name));
  if (!list) context.fail(node.span, "evaluating the index has undeclared this array");
  return {list, place_of(context, *node.subscript, index, *list, list->elements.size())};
}

Slot* find_in_list(Context& context, const Node& place) {
  const ListElement element = element_of_list(context, place);
  return element.list ? slot_of(context, place.span, *element.list, element.place) : nullptr;
}

}  // namespace

void fail_undeclared(Context& context, SourceSpan span, Symbol name) {
  if (grammar::is_newer_word(name)) context.fail(span, grammar::newer_word_message(context.text(name)));
  context.fail(span, fmt::format("undeclared identifier `{}`", context.text(name)), context.suggest_declared(name));
}

void read_place(Context& context, const Node& place, Value& result) {
  const Slot* slot = nullptr;
  if (const auto [list, i] = element_of_list(context, place); list) {
    if (const double* const number = list->elements.number(i)) return result.set_number(*number);
    slot = slot_of(context, place.span, *list, i);
  } else {
    slot = place.kind == NodeKind::index ? find_on_path(context, place, Purpose::use)
                                         : root_slot(context, place, Purpose::use);
  }
  if (slot->value.kind() == ValueKind::none) context.fail(place.span, "this array element is not set");
  if (slot->value.kind() == ValueKind::poison) throw Failed{};
  result = slot->value;
}

Slot& find_slot(Context& context, const Node& place) {
  if (Slot* const slot = find_in_list(context, place)) return *slot;
  if (place.kind == NodeKind::index || place.kind == NodeKind::dot) return *find_on_path(context, place, Purpose::use);
  return *root_slot(context, place, Purpose::use);
}

Slot* find_slot_if_declared(Context& context, const Node& place) {
  if (Slot* const slot = find_in_list(context, place)) return slot;
  if (place.kind == NodeKind::index || place.kind == NodeKind::dot) return find_on_path(context, place, Purpose::ask);
  return root_slot(context, place, Purpose::ask);
}

Slot& slot_to_write(Context& context, const Node& place, bool local) {
  if (place.kind == NodeKind::name) {
    const Symbol name = as<grammar::Name>(place).name;
    return local ? context.scopes.local(name) : context.scopes.declare(name);
  }
  if (place.kind == NodeKind::scoped_name) {
    const auto& scoped = as<grammar::ScopedName>(place);
    static_cast<void>(scoped_slot(context, scoped));
    if (local) context.fail(place.span, "`#local` cannot declare a name of a stated scope", "write `#declare` here");
    const bool is_local = scoped.scope == grammar::ScopeName::local;
    return is_local ? context.scopes.local(scoped.name) : context.scopes.global(scoped.name);
  }
  if (Slot* const slot = find_in_list(context, place)) return *slot;
  if (place.kind == NodeKind::error) context.meet(as<grammar::Error>(place));
  if (place.kind != NodeKind::index && place.kind != NodeKind::dot) throw Failed{};
  return *find_on_path(context, place, Purpose::write);
}

bool is_field(Context& context, const Node& place) {
  if (place.kind != NodeKind::dot || !grammar::is_place(*as<grammar::Dot>(place).base)) return false;
  const Slot* const base = find_slot_if_declared(context, *as<grammar::Dot>(place).base);
  return base != nullptr && base->value.kind() == ValueKind::dictionary;
}

Slot& find_field(Context& context, const grammar::Dot& node, const Value& base) {
  return *field_at(context, base.as<DictionaryValue>(), {&node, {}}, Purpose::use);
}

namespace {

/// Removes a key of a dictionary; true if the place is one.
bool remove_field(Context& context, const Node& place) {
  const bool is_index = place.kind == NodeKind::index;
  if (!is_index && place.kind != NodeKind::dot) return false;
  Step step{&place, {}};
  if (is_index) step.subscript = evaluate(context, *as<grammar::Index>(place).subscript);
  const Node& base = is_index ? *as<grammar::Index>(place).base : *as<grammar::Dot>(place).base;
  const Slot* const holder = find_slot_if_declared(context, base);
  if (!holder || holder->value.kind() != ValueKind::dictionary) return false;
  const std::string key = key_of(context, step);
  if (!holder->value.as<DictionaryValue>().remove(key))
    context.warn(place.span, fmt::format("the dictionary has no value `{}` to remove", key));
  return true;
}

}  // namespace

void undefine(Context& context, const Node& place) {
  if (place.kind == NodeKind::name) {
    const Symbol name = as<grammar::Name>(place).name;
    static_cast<void>(used(context, context.scopes.find(name), place.span));
    context.scopes.undef(name);
  } else if (place.kind == NodeKind::scoped_name) {
    const auto& scoped = as<grammar::ScopedName>(place);
    static_cast<void>(scoped_slot(context, scoped));
    const bool is_local = scoped.scope == grammar::ScopeName::local;
    is_local ? context.scopes.undef_local(scoped.name) : context.scopes.undef_global(scoped.name);
  } else if (!remove_field(context, place)) {
    if (Slot* const slot = find_slot_if_declared(context, place)) slot->value = Value();
  }
}

void check_container_depth(Context& context, const Value& element, SourceSpan span) {
  context.check_value_depth(span, 1 + container_depth(element, scene::kMaxValueDepth));
}

}  // namespace isl::interpreter
