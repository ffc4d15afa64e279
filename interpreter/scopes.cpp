#include "interpreter/scopes.h"

#include "base/check.h"

namespace isl::interpreter {

using grammar::Symbol;

SlotPool::~SlotPool() {
  for (Slot* slot : free_) delete slot;
}

Scopes::~Scopes() {
  while (!table_begin_.empty()) leave();
  for (Binding& binding : innermost_) {
    while (binding.slot) pop(binding);
  }
  for (const Binding* binding : spare_) delete binding;
}

Slot& Scopes::declare(Symbol name) {
  if (Slot* found = find(name)) return *found;
  return global(name);
}

Slot& Scopes::local(Symbol name) {
  Binding& top = innermost(name);
  if (top.slot && top.table == table_begin_.size()) return *top.slot;
  push(top, slots_.make());
  if (!table_begin_.empty()) bound_.push_back(name);
  return *top.slot;
}

Slot& Scopes::global(Symbol name) {
  Binding* binding = &innermost(name);
  while (binding->outer) binding = binding->outer;
  if (binding->slot && binding->table == 0) return *binding->slot;
  Slot* slot = slots_.make();
  if (binding->slot) {
    binding->outer = new Binding{slot, 0, nullptr};
  } else {
    *binding = {slot, 0, nullptr};
  }
  return *slot;
}

bool Scopes::undef(Symbol name) {
  Binding& top = innermost(name);
  if (!top.slot) return false;
  pop(top);
  return true;
}

void Scopes::make_room(std::uint32_t symbol) { innermost_.resize(symbol + symbol / 2 + 64); }

std::vector<Symbol> Scopes::declared() const {
  std::vector<Symbol> names;
  for (std::uint32_t i = 0; i < innermost_.size(); ++i) {
    if (innermost_[i].slot) names.push_back(Symbol{i});
  }
  return names;
}

}  // namespace isl::interpreter
