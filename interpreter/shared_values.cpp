#include "interpreter/shared_values.h"

namespace isl::interpreter {

std::string_view describe(const Value& value) {
  switch (value.kind()) {
    case ValueKind::none: return "an array element that is not set";
    case ValueKind::poison: return "nothing";
    case ValueKind::numeric: {
      static constexpr std::string_view kNames[] = {
          "", "a number", "a 2-term vector", "a 3-term vector", "a 4-term vector", "a colour"};
      return kNames[value.term_count()];
    }
    case ValueKind::string: return "a string";
    case ValueKind::array: return "an array";
    case ValueKind::macro: return "a macro";
    case ValueKind::object: return "an object";
    case ValueKind::pigment: return "a pigment";
    case ValueKind::normal: return "a normal";
    case ValueKind::finish: return "a finish";
    case ValueKind::texture: return "a texture";
    case ValueKind::material: return "a material";
    case ValueKind::interior: return "an interior";
    case ValueKind::colour_map: return "a color_map";
    case ValueKind::pigment_map: return "a pigment_map";
    case ValueKind::normal_map: return "a normal_map";
    case ValueKind::slope_map: return "a slope_map";
    case ValueKind::texture_map: return "a texture_map";
    case ValueKind::statement: return value.as<StatementValue>().statement.kind->noun;
    case ValueKind::transform: return "a transform";
    case ValueKind::camera: return "a camera";
    case ValueKind::function: return "a function";
    case ValueKind::spline: return "a spline";
    case ValueKind::file: return "an open file";
    case ValueKind::deprecated: return "a deprecated name";
  }
  return "";
}

ArrayValue::ArrayValue(std::vector<std::size_t> dimensions_, SlotPool& pool_, MemoryAccount& account_)
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
  // An array has lists of its dimensions and elements, and the allocator adds up to 16 bytes to each: many small arrays
  // are mostly that.
  constexpr std::size_t kAddedByAllocator = 16;
  constexpr std::size_t kBytesOfPointer = sizeof(void*);
  return sizeof(ArrayValue) + 2 * sizeof(std::size_t) + 3 * kAddedByAllocator + elements * kBytesOfPointer;
}

std::size_t ArrayValue::bytes_of(std::size_t elements) { return own_bytes(elements) + elements * kSlotBytes; }

std::size_t ArrayValue::bytes_of_copy() const {
  std::size_t bytes = 0;
  std::vector<const ArrayValue*> pending{this};  // a list instead of recursion, so that depth costs no stack
  while (!pending.empty()) {
    const ArrayValue& next = *pending.back();
    pending.pop_back();
    bytes += bytes_of(next.elements.size());
    for (const Slot* const element : next.elements) {
      if (element->value.kind() == ValueKind::array) pending.push_back(&element->value.as<ArrayValue>());
    }
  }
  return bytes;
}

Ref<ArrayValue> ArrayValue::copy() const {
  Ref<ArrayValue> result = make_shared_value<ArrayValue>(dimensions, pool, account);
  struct Copy {
    const ArrayValue* from;
    ArrayValue* to;
  };
  std::vector<Copy> pending{{this, result.get()}};  // a list instead of recursion, so that depth costs no stack
  while (!pending.empty()) {
    const Copy next = pending.back();
    pending.pop_back();
    for (std::size_t i = 0; i < next.from->elements.size(); ++i) {
      const Value& value = next.from->elements[i]->value;
      Value& copied = next.to->elements[i]->value;
      if (value.kind() != ValueKind::array) {
        copied = value;
        continue;
      }
      const ArrayValue& inner = value.as<ArrayValue>();
      Ref<ArrayValue> inner_copy = make_shared_value<ArrayValue>(inner.dimensions, pool, account);
      pending.push_back({&inner, inner_copy.get()});
      copied = Value(ValueKind::array, std::move(inner_copy));
    }
  }
  return result;
}

}  // namespace isl::interpreter
