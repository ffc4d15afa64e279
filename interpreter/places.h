// Places: what a name, `local.Name`, an array's element `A[i]` or a dictionary's value `D.Key`, `D["key"]` refers to,
// in any combination (`D.Limbs[2].Length`). A place is a slot, which can be read, written and passed by reference.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// The value of a place that must be declared. A number in an array is read without a slot being made for it.
void read_place(Context& context, const grammar::Node& place, Value& result);
/// The slot of a place that must be declared.
[[nodiscard]] Slot& find_slot(Context& context, const grammar::Node& place);
/// The same; null if it is not declared, or if it is an item of a vector.
[[nodiscard]] Slot* find_slot_if_declared(Context& context, const grammar::Node& place);
/// The slot that `#declare place` or `#local place` writes: a name that is not declared and a key that a dictionary
/// does not have yet are made, and an array without a size grows.
[[nodiscard]] Slot& slot_to_write(Context& context, const grammar::Node& place, bool local);
/// `#undef place`.
void undefine(Context& context, const grammar::Node& place);

/// True for a value of a dictionary, declared or not; false for an item of a vector, and for all other places.
[[nodiscard]] bool is_field(Context& context, const grammar::Node& place);
/// The slot of a dictionary's value, whose dictionary is at hand.
[[nodiscard]] Slot& find_field(Context& context, const grammar::Dot& node, const Value& base);

/// Fails if a container with this element would be deeper than values may be.
void check_container_depth(Context& context, const Value& element, SourceSpan span);

/// The message that no such name is declared.
[[noreturn]] void fail_undeclared(Context& context, SourceSpan span, grammar::Symbol name);

}  // namespace isl::interpreter
