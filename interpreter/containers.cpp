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
    for (Slot* const element : container.as<ArrayValue>().elements) {
      if (!visit(*element)) return;
    }
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

std::vector<Slot*> slots_of(const Value& container) {
  std::vector<Slot*> slots;
  visit_slots(container, [&](Slot& slot) {
    slots.push_back(&slot);
    return true;
  });
  return slots;
}

}  // namespace

// ---- Arrays ---------------------------------------------------------------------------------------------------------

ArrayValue::ArrayValue(std::vector<std::size_t> dimensions_, SlotPool& pool_, Charge& account_)
    : dimensions(std::move(dimensions_)), pool(pool_), account(account_) {
  std::size_t count = 1;
  for (const std::size_t size : dimensions) count *= size;
  elements.resize(count);
  for (Slot*& element : elements) element = pool.make();
  account.add(own_bytes(count));
}

ArrayValue::~ArrayValue() {
  pool.release_elements(elements);
  account.remove(own_bytes(elements.size()));
}

std::size_t ArrayValue::own_bytes(std::size_t elements) {
  // An array has lists of its dimensions and elements.
  constexpr std::size_t kBytesOfPointer = sizeof(void*);
  return sizeof(ArrayValue) + 2 * sizeof(std::size_t) + 3 * kAddedByAllocator + elements * kBytesOfPointer;
}

std::size_t ArrayValue::bytes_of(std::size_t elements) { return own_bytes(elements) + elements * kSlotBytes; }

void ArrayValue::grow(std::size_t size) {
  account.add(own_bytes(size) - own_bytes(elements.size()));
  while (elements.size() < size) elements.push_back(pool.make());
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
    const std::vector<Slot*> from = slots_of(next.from), to = slots_of(next.to);
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Value& value = from[i]->value;
      to[i]->value = is_container(value) ? empty_copy(value) : value;
      if (is_container(value)) pending.push_back({value, to[i]->value});
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
      bytes += ArrayValue::bytes_of(next.as<ArrayValue>().elements.size());
    } else {
      bytes += sizeof(DictionaryValue) + kAddedByAllocator;
      for (const auto& [key, slot] : next.as<DictionaryValue>().fields)
        bytes += DictionaryValue::bytes_of_field(key) + kSlotBytes;
    }
    visit_slots(next, [&](const Slot& slot) {
      if (is_container(slot.value)) pending.push_back(&slot.value);
      return true;
    });
  }
  return bytes;
}

}  // namespace isl::interpreter
