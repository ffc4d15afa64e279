// The elements of an array. A number takes eight bytes. An element gets a slot of its own when it holds anything else,
// or when its place is asked for, which may be passed to a macro by reference.
#pragma once

#include "base/budget.h"
#include "interpreter/scopes.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace isl::interpreter {

class ArrayElements {
 public:
  ArrayElements(SlotPool& pool, Charge& account) : pool_(pool), account_(account) {}
  ArrayElements(const ArrayElements&) = delete;
  ArrayElements& operator=(const ArrayElements&) = delete;
  ~ArrayElements();

  /// Bytes of so many elements without slots.
  [[nodiscard]] static std::size_t bytes_of(std::size_t elements) { return elements * sizeof(double); }
  /// Bytes of these elements without the slots themselves.
  [[nodiscard]] std::size_t bytes() const { return bytes_of(size()) + slots_.size() * sizeof(void*); }

  [[nodiscard]] std::size_t size() const { return numbers_.size(); }
  /// Makes it longer; the new elements are not set.
  void grow(std::size_t size);
  /// Sets the elements that are numbers without a slot as they are in another one of the same size.
  void copy_numbers(const ArrayElements& other) { numbers_ = other.numbers_; }

  /// The number that the element is, or null. Valid until the element changes.
  [[nodiscard]] const double* number(std::size_t i) const {
    if (const Slot* const slot = slot_at(i)) return slot->value.is_number() ? slot->value.terms().data() : nullptr;
    return is_set(numbers_[i]) ? &numbers_[i] : nullptr;
  }
  /// False if the element holds what a declaration may not replace as it is, such as a function.
  [[nodiscard]] bool set_number(std::size_t i, double number) {
    if (Slot* const slot = slot_at(i)) {
      if (slot->value.kind() >= ValueKind::function) return false;
      slot->value.set_number(number);
    } else {
      numbers_[i] = number;
    }
    return true;
  }
  void set(std::size_t i, Value value);

  [[nodiscard]] bool has_slot(std::size_t i) const { return slot_at(i) != nullptr; }
  /// The element's slot, made if there is none.
  [[nodiscard]] Slot& slot(std::size_t i);
  /// Bytes that the next slot takes.
  [[nodiscard]] std::size_t bytes_of_slot() const { return kSlotBytes + (slots_.empty() ? size() * sizeof(void*) : 0); }

  /// Calls `visit` with the place and the slot of each element that has one, until it returns false.
  template <class Visit>
  void visit_slots(Visit visit) const {
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if (slots_[i] && !visit(i, *slots_[i])) return;
    }
  }

 private:
  /// An element that is not set is a NaN that is told by its bits. No operation yields them, because they are in no
  /// operand.
  static constexpr double kUnset = std::bit_cast<double>(std::uint64_t{0x7ff8'0000'0000'0001});
  [[nodiscard]] static bool is_set(double number) {
    return std::bit_cast<std::uint64_t>(number) != std::bit_cast<std::uint64_t>(kUnset);
  }

  [[nodiscard]] Slot* slot_at(std::size_t i) const { return slots_.empty() ? nullptr : slots_[i]; }

  std::vector<double> numbers_;  ///< not set where the element has a slot
  std::vector<Slot*> slots_;     ///< empty while no element has one
  SlotPool& pool_;
  Charge& account_;
};

}  // namespace isl::interpreter
