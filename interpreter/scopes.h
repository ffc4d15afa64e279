// Names and their values. Scoping is dynamic, as in POV-Ray: a macro sees its caller's locals. It is implemented by
// shallow binding: each symbol has its innermost binding at hand, so that a lookup is one array access; a trail
// remembers what each binding hides, and restores it when the scope ends.
#pragma once

#include "base/budget.h"
#include "base/check.h"
#include "grammar/symbols.h"
#include "interpreter/value.h"

#include <vector>

namespace isl::interpreter {

/// The storage of one value. Counted, because a macro parameter may be bound to its caller's slot, or to an array's
/// element, and must survive that name's #undef.
struct Slot {
  Value value;
  union {
    std::uint32_t references = 0;  ///< while it is in use
    Slot* next_free;               ///< while it waits in its pool
  };
};

/// Bytes of a slot, with what the allocator adds to a small piece of memory.
inline constexpr std::size_t kSlotBytes = sizeof(Slot) + 16;

/// Slots are many and short-lived: they are recycled rather than freed.
class SlotPool {
 public:
  /// `account` counts the slots, those that wait for their next use too.
  explicit SlotPool(Charge* account = nullptr) : account_(account) {}
  SlotPool(const SlotPool&) = delete;
  SlotPool& operator=(const SlotPool&) = delete;
  ~SlotPool();

  [[nodiscard]] Slot* make();
  void retain(Slot* slot) { ++slot->references; }
  void release(Slot* slot) {
    if (--slot->references == 0) {
      slot->value.reset();
      slot->next_free = free_;
      free_ = slot;
    }
  }
  /// Releases the slots of a container (containers.h), null or not. Containers among their values are destroyed from a
  /// list, so that however deep containers are within containers, they take no stack.
  void release_elements(const std::vector<Slot*>& elements);

 private:
  Slot* free_ = nullptr;   ///< the first free slot
  Slot* dying_ = nullptr;  ///< the first slot that is no longer used and whose container is still to be destroyed
  bool is_destroying_ = false;
  Charge* account_;  ///< may be null
};

class Scopes {
 public:
  explicit Scopes(Charge* account = nullptr) : slots_(account) {}
  Scopes(const Scopes&) = delete;
  Scopes& operator=(const Scopes&) = delete;
  ~Scopes();

  [[nodiscard]] SlotPool& slots() { return slots_; }

  /// The innermost binding, or null if the name is not declared.
  [[nodiscard]] Slot* find(grammar::Symbol name) const {
    const auto i = static_cast<std::uint32_t>(name);
    return i < innermost_.size() ? innermost_[i].slot : nullptr;
  }

  /// The binding in the current table, or in the global one even if it is hidden; null if there is none.
  [[nodiscard]] Slot* find_local(grammar::Symbol name) const;
  [[nodiscard]] Slot* find_global(grammar::Symbol name) const;
  /// Keeps a place for the name, so that find_known() may be asked for it.
  void make_room_for(grammar::Symbol name) { static_cast<void>(innermost(name)); }
  /// find() without a look at whether the name has a place.
  [[nodiscard]] Slot* find_known(grammar::Symbol name) const {
    return innermost_[static_cast<std::uint32_t>(name)].slot;
  }

  /// The slot that `#declare name` writes: the innermost binding, or a new one in the global table.
  [[nodiscard]] Slot& declare(grammar::Symbol name);
  /// The slot that `#local name` writes: the binding in the current table, made if there is none.
  [[nodiscard]] Slot& local(grammar::Symbol name);
  /// The binding in the global table, even if it is hidden: macros are declared there.
  [[nodiscard]] Slot& global(grammar::Symbol name);
  /// Binds a parameter in the current table to an existing slot, taking over one reference to it.
  void bind(grammar::Symbol name, Slot* slot);
  // Each returns false if there is no such binding.
  /// Removes the innermost binding.
  bool undef(grammar::Symbol name);
  /// Removes the binding in the current table, or in the global one.
  bool undef_local(grammar::Symbol name);
  bool undef_global(grammar::Symbol name);

  /// Opens a new table: each include file and each macro call has one.
  void enter();
  void leave();

  /// All names that are declared now, for "did you mean".
  [[nodiscard]] std::vector<grammar::Symbol> declared() const;

 private:
  struct Binding {
    Slot* slot = nullptr;     ///< null if undeclared
    std::uint32_t table = 0;  ///< the global one is 0
  };
  /// A binding of a table other than the global one.
  struct Trace {
    grammar::Symbol name;  ///< kNoSymbol if an #undef removed it
    std::uint32_t hidden_table;
    Slot* hidden_slot;

    [[nodiscard]] Binding hidden() const { return {hidden_slot, hidden_table}; }
  };

  Binding& innermost(grammar::Symbol name);
  [[nodiscard]] Slot& new_local(grammar::Symbol name);
  void make_room(std::uint32_t symbol);
  [[nodiscard]] std::uint32_t table() const { return static_cast<std::uint32_t>(table_begin_.size()); }

  SlotPool slots_;
  std::vector<Binding> innermost_;        ///< by symbol
  std::vector<Trace> trail_;              ///< of every open table, outermost first
  std::vector<std::size_t> table_begin_;  ///< index in trail_ at which each open table but the global one begins
};

// ---- Inline: every macro call runs these ----------------------------------------------------------------------------

inline Slot* SlotPool::make() {
  Slot* slot = free_;
  if (!slot) [[unlikely]] {
    slot = new Slot;
    if (account_ != nullptr) account_->add(kSlotBytes);
  } else {
    free_ = slot->next_free;
  }
  slot->references = 1;
  return slot;
}

inline Scopes::Binding& Scopes::innermost(grammar::Symbol name) {
  const auto i = static_cast<std::uint32_t>(name);
  if (i >= innermost_.size()) [[unlikely]]
    make_room(i);
  return innermost_[i];
}

inline void Scopes::bind(grammar::Symbol name, Slot* slot) {
  ISL_DCHECK(table() > 0);
  Binding& top = innermost(name);
  trail_.push_back({name, top.table, top.slot});
  top = {slot, table()};
}

inline Slot& Scopes::declare(grammar::Symbol name) {
  Slot* const found = find(name);
  return found ? *found : global(name);
}

inline Slot& Scopes::local(grammar::Symbol name) {
  const Binding& top = innermost(name);
  return top.slot && top.table == table() ? *top.slot : new_local(name);
}

inline void Scopes::enter() { table_begin_.push_back(trail_.size()); }

inline void Scopes::leave() {
  const auto begin = trail_.begin() + static_cast<std::ptrdiff_t>(table_begin_.back());
  for (auto trace = trail_.end(); trace != begin;) {
    --trace;
    if (trace->name == grammar::kNoSymbol) [[unlikely]]
      continue;
    Binding& top = innermost_[static_cast<std::uint32_t>(trace->name)];
    slots_.release(top.slot);
    top = trace->hidden();
  }
  trail_.erase(begin, trail_.end());
  table_begin_.pop_back();
}

}  // namespace isl::interpreter
