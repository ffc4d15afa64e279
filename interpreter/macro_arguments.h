// The actual arguments of a macro call, evaluated in the caller's scope before the parameters are bound.
#pragma once

#include "interpreter/context.h"

#include <span>

namespace isl::interpreter {

/// The actual arguments of one macro call, in the slots that its parameters will be bound to: the caller's own for a
/// lone identifier (by reference), new ones for everything else.
class ArgumentSlots {
 public:
  ArgumentSlots(Context& context, const grammar::Call& call, const grammar::Macro& definition);
  ~ArgumentSlots() { release(); }
  ArgumentSlots(const ArgumentSlots&) = delete;
  ArgumentSlots& operator=(const ArgumentSlots&) = delete;

  /// Binds them to the parameters in the scope that was just entered, and is empty then.
  void bind_to(std::span<const grammar::Symbol> parameters);

 private:
  void read(const grammar::Argument& argument);
  void read_stream(const grammar::Argument& argument);
  /// A new slot's value, to be set.
  [[nodiscard]] Value& push();
  void push_reference(Slot& slot);
  void release();

  Context& context_;
  std::size_t begin_;  ///< the slots lie on Context::argument_slots, which nested calls share
};

}  // namespace isl::interpreter
