#include "interpreter/containers.h"

#include <algorithm>

namespace isl::interpreter {
namespace {

// The allocator adds up to so many bytes to each piece of memory: small containers are mostly that.
constexpr std::size_t kAddedByAllocator = 16;

/// Calls `visit` with each slot of a container, until it returns false.
template <class Visit>
void visit_slots(const Value& container, Visit visit) {
  if (container.kind() == ValueKind::array) {
    container.as<ArrayValue>().elements.visit_slots([&](std::size_t, Slot& slot) { return visit(slot); });
  } else {
    for (const auto& [key, slot] : container.as<DictionaryValue>().fields) {
      if (!visit(*slot)) return;
    }
  }
}

/// A container of the same kind and shape, or of the same keys, without values.
Value empty_copy(const Value& container) {
  if (container.kind() == ValueKind::array) {
    const auto& array = container.as<ArrayValue>();
    const auto copy = make_shared_value<ArrayValue>(array.dimensions, array.pool, array.account);
    copy->grows = array.grows;
    return {ValueKind::array, copy};
  }
  const auto& dictionary = container.as<DictionaryValue>();
  const auto copy = make_shared_value<DictionaryValue>(dictionary.pool, dictionary.account);
  for (const auto& [key, slot] : dictionary.fields) static_cast<void>(copy->add(key));
  return {ValueKind::dictionary, copy};
}

}  // namespace

// ---- Arrays ---------------------------------------------------------------------------------------------------------

ArrayValue::ArrayValue(std::vector<std::size_t> dimensions_, SlotPool& pool_, Charge& account_)
    : dimensions(std::move(dimensions_)), elements(pool_, account_), pool(pool_), account(account_) {
  account.add(bytes_of(0));
  std::size_t count = 1;
  for (const std::size_t size : dimensions) count *= size;
  elements.grow(count);
}

ArrayValue::~ArrayValue() { account.remove(bytes_of(0)); }

std::size_t ArrayValue::bytes_of(std::size_t elements) {
  // An array has lists of its dimensions and elements.
  return sizeof(ArrayValue) + 2 * sizeof(std::size_t) + 3 * kAddedByAllocator + ArrayElements::bytes_of(elements);
}

void ArrayValue::grow(std::size_t size) {
  elements.grow(size);
  dimensions = {size};
}

// ---- Dictionaries ---------------------------------------------------------------------------------------------------

DictionaryValue::DictionaryValue(SlotPool& pool_, Charge& account_) : pool(pool_), account(account_) {
  account.add(sizeof(DictionaryValue) + kAddedByAllocator);
}

DictionaryValue::~DictionaryValue() {
  std::vector<Slot*> slots;
  std::size_t bytes = sizeof(DictionaryValue) + kAddedByAllocator;
  for (const auto& [key, slot] : fields) {
    slots.push_back(slot);
    bytes += bytes_of_field(key);
  }
  pool.release_elements(slots);
  account.remove(bytes);
}

std::size_t DictionaryValue::bytes_of_field(std::string_view key) {
  constexpr std::size_t kLinks = 4 * sizeof(void*);  // of a node of the tree
  return kLinks + sizeof(std::pair<const std::string, Slot*>) + 2 * kAddedByAllocator + key.size();
}

Slot* DictionaryValue::find(std::string_view key) const {
  const auto field = fields.find(key);
  return field == fields.end() ? nullptr : field->second;
}

Slot& DictionaryValue::add(std::string_view key) {
  if (Slot* const slot = find(key)) return *slot;
  account.add(bytes_of_field(key));
  return *fields.emplace(key, pool.make()).first->second;
}

bool DictionaryValue::remove(std::string_view key) {
  const auto field = fields.find(key);
  if (field == fields.end()) return false;
  pool.release(field->second);
  account.remove(bytes_of_field(key));
  fields.erase(field);
  return true;
}

// ---- Both -----------------------------------------------------------------------------------------------------------

std::uint32_t container_depth(const Value& value, std::uint32_t most) {
  if (!is_container(value) || most == 0) return 0;
  std::uint32_t deepest = 0;
  visit_slots(value, [&](const Slot& slot) {
    deepest = std::max(deepest, container_depth(slot.value, most - 1));
    return deepest + 1 < most;
  });
  return deepest + 1;
}

Value copy_of_container(const Value& container) {
  struct Copy {
    Value from, to;
  };
  Value result = empty_copy(container);
  std::vector<Copy> pending{{container, result}};
  while (!pending.empty()) {
    const Copy next = std::move(pending.back());
    pending.pop_back();
    const auto copy_slot = [&](const Value& value, Value& copy) {
      copy = is_container(value) ? empty_copy(value) : value;
      if (is_container(value)) pending.push_back({value, copy});
    };
    if (next.from.kind() == ValueKind::array) {
      const ArrayElements& from = next.from.as<ArrayValue>().elements;
      ArrayElements& to = next.to.as<ArrayValue>().elements;
      to.copy_numbers(from);
      from.visit_slots([&](std::size_t i, const Slot& slot) {
        if (slot.value.is_number()) {
          to.set(i, slot.value);
        } else if (slot.value.kind() != ValueKind::none) {
          copy_slot(slot.value, to.slot(i).value);
        }
        return true;
      });
    } else {
      const DictionaryValue& from = next.from.as<DictionaryValue>();
      for (const auto& [key, slot] : from.fields) copy_slot(slot->value, next.to.as<DictionaryValue>().add(key).value);
    }
  }
  return result;
}

std::size_t bytes_of_copy(const Value& container) {
  std::size_t bytes = 0;
  std::vector<const Value*> pending{&container};
  while (!pending.empty()) {
    const Value& next = *pending.back();
    pending.pop_back();
    if (next.kind() == ValueKind::array) {
      bytes += ArrayValue::bytes_of(0) + next.as<ArrayValue>().elements.bytes();
    } else {
      bytes += sizeof(DictionaryValue) + kAddedByAllocator;
      for (const auto& [key, slot] : next.as<DictionaryValue>().fields) bytes += DictionaryValue::bytes_of_field(key);
    }
    visit_slots(next, [&](const Slot& slot) {
      bytes += kSlotBytes;
      if (is_container(slot.value)) pending.push_back(&slot.value);
      return true;
    });
  }
  return bytes;
}

}  // namespace isl::interpreter
