#include "interpreter/array_elements.h"

namespace isl::interpreter {

ArrayElements::~ArrayElements() {
  pool_.release_elements(slots_);
  account_.remove(bytes());
}

void ArrayElements::grow(std::size_t size) {
  const std::size_t before = bytes();
  numbers_.resize(size, kUnset);
  if (!slots_.empty()) slots_.resize(size);
  account_.add(bytes() - before);
}

void ArrayElements::set(std::size_t i, Value value) {
  if (value.is_number() && !has_slot(i)) {
    numbers_[i] = value.number();
  } else {
    slot(i).value = std::move(value);
  }
}

Slot& ArrayElements::slot(std::size_t i) {
  if (Slot* const slot = slot_at(i)) return *slot;
  if (slots_.empty()) {
    const std::size_t before = bytes();
    slots_.resize(size());
    account_.add(bytes() - before);
  }
  slots_[i] = pool_.make();
  if (is_set(numbers_[i])) slots_[i]->value.set_number(numbers_[i]);
  numbers_[i] = kUnset;
  return *slots_[i];
}

}  // namespace isl::interpreter
