#include "interpreter/spare_semicolons.h"

#include "interpreter/expressions.h"
#include "interpreter/places.h"
#include "interpreter/shared_values.h"

#include <cstddef>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Items;
using grammar::Node;
using grammar::NodeKind;

/// False if the declaration is known to have a value that is not a number. Unknown are an array's element, which is not
/// looked up twice, and a macro's local, which is gone by then.
bool may_declare_number(Context& context, const Node* item, bool is_in_scope) {
  if (!item || (item->kind != NodeKind::declare && item->kind != NodeKind::declare_deprecated)) return false;
  const auto& declaration = as<grammar::Declare>(*item);
  if (declaration.target->kind != NodeKind::name || (declaration.local && !is_in_scope)) return true;
  const Slot* const slot = find_slot_if_declared(context, *declaration.target);
  return !slot || slot->value.kind() <= ValueKind::numeric;
}

/// The last item of the called macro, or null.
const Node* last_of_callee(Context& context, const Node& item) {
  const Node& callee = *as<grammar::Call>(item).callee;
  if (callee.kind != NodeKind::name) return nullptr;
  const Slot* const slot = context.scopes.find(as<grammar::Name>(callee).name);
  if (!slot || slot->value.kind() != ValueKind::macro) return nullptr;
  const Items body = slot->value.as<MacroValue>().definition.body;
  return body.empty() ? nullptr : body.back();
}

}  // namespace

bool is_spare(Context& context, const grammar::Semicolon& semicolon) {
  const Node* before = semicolon.after;
  // The depth limit bounds the calls that were nested; macros may end by calling themselves.
  for (std::size_t calls = 0; before && before->kind == NodeKind::call; ++calls) {
    if (calls == context.options.limits.max_depth) return false;
    before = last_of_callee(context, *before);
  }
  const bool is_in_scope = before == semicolon.after;
  return before && before->kind == NodeKind::semicolon &&
         may_declare_number(context, as<grammar::Semicolon>(*before).after, is_in_scope);
}

}  // namespace isl::interpreter
