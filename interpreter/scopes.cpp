#include "interpreter/scopes.h"

#include <algorithm>
#include <utility>

namespace isl::interpreter {

using grammar::Symbol;

SlotPool::~SlotPool() {
  while (free_) {
    delete std::exchange(free_, free_->next_free);
    if (account_ != nullptr) account_->remove(kSlotBytes);
  }
}

void SlotPool::release_elements(const std::vector<Slot*>& elements) {
  for (Slot* const element : elements) {
    if (!element) continue;
    if (element->value.kind() != ValueKind::array && element->value.kind() != ValueKind::dictionary) {
      release(element);
    } else if (--element->references == 0) {
      element->next_free = dying_;
      dying_ = element;
    }
  }
  if (is_destroying_) return;  // the loop below destroyed this array and goes on with its elements
  is_destroying_ = true;
  while (dying_) {
    Slot* const slot = std::exchange(dying_, dying_->next_free);
    slot->value.reset();
    slot->next_free = free_;
    free_ = slot;
  }
  is_destroying_ = false;
}

Scopes::~Scopes() {
  while (!table_begin_.empty()) leave();
  for (const Binding& binding : innermost_) {
    if (binding.slot) slots_.release(binding.slot);
  }
}

Slot& Scopes::new_local(Symbol name) {
  Slot* const slot = slots_.make();
  if (table() > 0) {
    bind(name, slot);
  } else {
    innermost(name) = {slot, 0};
  }
  return *slot;
}

Slot& Scopes::global(Symbol name) {
  Binding& top = innermost(name);
  const bool is_hidden = top.slot && top.table > 0;
  // The outermost trace that hides the global binding holds it.
  Slot*& slot = is_hidden ? std::ranges::find(trail_, name, &Trace::name)->hidden_slot : top.slot;
  if (!slot) slot = slots_.make();
  return *slot;
}

bool Scopes::undef(Symbol name) {
  Binding& top = innermost(name);
  if (!top.slot) return false;
  slots_.release(top.slot);
  if (top.table == 0) {
    top = {};
  } else {
    auto trace = trail_.rbegin();
    while (trace->name != name) ++trace;
    trace->name = grammar::kNoSymbol;
    top = trace->hidden();
  }
  return true;
}

Slot* Scopes::find_local(Symbol name) const {
  const auto i = static_cast<std::uint32_t>(name);
  const bool is_here = i < innermost_.size() && innermost_[i].slot && innermost_[i].table == table();
  return is_here ? innermost_[i].slot : nullptr;
}

Slot* Scopes::find_global(Symbol name) const {
  const auto i = static_cast<std::uint32_t>(name);
  if (i >= innermost_.size() || !innermost_[i].slot) return nullptr;
  if (innermost_[i].table == 0) return innermost_[i].slot;
  return std::ranges::find(trail_, name, &Trace::name)->hidden_slot;
}

bool Scopes::undef_local(Symbol name) { return find_local(name) && undef(name); }

bool Scopes::undef_global(Symbol name) {
  Slot* const slot = find_global(name);
  if (!slot) return false;
  if (innermost(name).table == 0) return undef(name);
  std::ranges::find(trail_, name, &Trace::name)->hidden_slot = nullptr;
  slots_.release(slot);
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
