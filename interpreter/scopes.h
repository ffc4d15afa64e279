// Names and what they stand for. Scoping is dynamic, as in POV-Ray: a macro sees its caller's locals. It is implemented
// by shallow binding: each symbol has its stack of bindings with the innermost on top, so that a lookup is one array
// access; a scope remembers what it bound and takes it off when it ends.
#pragma once

#include "grammar/symbols.h"
#include "interpreter/value.h"

#include <vector>

namespace isl::interpreter {

/// Where a value is kept. Counted, because a macro parameter may be bound to its caller's slot, or to an array's
/// element, and must survive that name's #undef.
struct Slot {
  Value value;
  std::uint32_t references = 0;
};

/// Slots are many and short-lived: they are recycled rather than freed.
class SlotPool {
 public:
  SlotPool() = default;
  SlotPool(const SlotPool&) = delete;
  SlotPool& operator=(const SlotPool&) = delete;
  ~SlotPool();

  [[nodiscard]] Slot* make();
  void retain(Slot* slot) { ++slot->references; }
  void release(Slot* slot) {
    if (--slot->references == 0) {
      slot->value.reset();
      free_.push_back(slot);
    }
  }

 private:
  std::vector<Slot*> free_;
};

class Scopes {
 public:
  Scopes() = default;
  Scopes(const Scopes&) = delete;
  Scopes& operator=(const Scopes&) = delete;
  ~Scopes();

  [[nodiscard]] SlotPool& slots() { return slots_; }

  /// The innermost binding, or null where the name is not declared.
  [[nodiscard]] Slot* find(grammar::Symbol name) const {
    const auto i = static_cast<std::uint32_t>(name);
    return i < innermost_.size() ? innermost_[i].slot : nullptr;
  }

  /// What `#declare name` writes: the innermost binding, or a new one in the global table.
  [[nodiscard]] Slot& declare(grammar::Symbol name);
  /// What `#local name` writes: the binding in the current table, made if there is none.
  [[nodiscard]] Slot& local(grammar::Symbol name);
  /// The binding in the global table, whatever hides it: where macros are declared.
  [[nodiscard]] Slot& global(grammar::Symbol name);
  /// Binds a parameter in the current table to an existing slot.
  void bind(grammar::Symbol name, Slot* slot);
  /// Takes the innermost binding away; false where there is none.
  bool undef(grammar::Symbol name);

  /// A new table: one an include file and one a macro call.
  void enter();
  void leave();

  /// All names that are declared now, for "did you mean".
  [[nodiscard]] std::vector<grammar::Symbol> declared() const;

 private:
  struct Binding {
    Slot* slot = nullptr;
    std::uint32_t table = 0;
    Binding* outer = nullptr;
  };

  Binding& innermost(grammar::Symbol name);
  void push(Binding& top, Slot* slot);
  void pop(Binding& top);

  SlotPool slots_;
  std::vector<Binding> innermost_;        ///< by symbol; slot null where undeclared
  std::vector<Binding*> spare_;           ///< recycled outer bindings
  std::vector<grammar::Symbol> bound_;    ///< by every open table, outermost first
  std::vector<std::size_t> table_begin_;  ///< where in bound_ each open table but the global one begins
};

}  // namespace isl::interpreter
