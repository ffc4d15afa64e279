#include "interpreter/scopes.h"

#include "base/check.h"

namespace isl::interpreter {

using grammar::Symbol;

SlotPool::~SlotPool() {
  for (Slot* slot : free_) delete slot;
}

Slot* SlotPool::make() {
  Slot* slot = nullptr;
  if (free_.empty()) {
    slot = new Slot;
  } else {
    slot = free_.back();
    free_.pop_back();
  }
  slot->references = 1;
  return slot;
}

Scopes::~Scopes() {
  while (!table_begin_.empty()) leave();
  for (Binding& binding : innermost_) {
    while (binding.slot) pop(binding);
  }
  for (const Binding* binding : spare_) delete binding;
}

Scopes::Binding& Scopes::innermost(Symbol name) {
  const auto i = static_cast<std::uint32_t>(name);
  if (i >= innermost_.size()) innermost_.resize(i + i / 2 + 64);
  return innermost_[i];
}

void Scopes::push(Binding& top, Slot* slot) {
  Binding* outer = nullptr;
  if (top.slot) {
    if (spare_.empty()) {
      outer = new Binding;
    } else {
      outer = spare_.back();
      spare_.pop_back();
    }
    *outer = top;
  }
  top = {slot, static_cast<std::uint32_t>(table_begin_.size()), outer};
}

void Scopes::pop(Binding& top) {
  slots_.release(top.slot);
  if (Binding* outer = top.outer) {
    top = *outer;
    spare_.push_back(outer);
  } else {
    top = {};
  }
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

void Scopes::bind(Symbol name, Slot* slot) {
  ISL_DCHECK(!table_begin_.empty());
  slots_.retain(slot);
  push(innermost(name), slot);
  bound_.push_back(name);
}

bool Scopes::undef(Symbol name) {
  Binding& top = innermost(name);
  if (!top.slot) return false;
  pop(top);
  return true;
}

void Scopes::enter() { table_begin_.push_back(bound_.size()); }

void Scopes::leave() {
  const auto table = static_cast<std::uint32_t>(table_begin_.size());
  while (bound_.size() > table_begin_.back()) {
    Binding& top = innermost_[static_cast<std::uint32_t>(bound_.back())];
    bound_.pop_back();
    // An #undef may have taken the binding away already.
    if (top.slot && top.table == table) pop(top);
  }
  table_begin_.pop_back();
}

std::vector<Symbol> Scopes::declared() const {
  std::vector<Symbol> names;
  for (std::uint32_t i = 0; i < innermost_.size(); ++i) {
    if (innermost_[i].slot) names.push_back(Symbol{i});
  }
  return names;
}

}  // namespace isl::interpreter
