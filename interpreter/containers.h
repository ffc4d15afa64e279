// Arrays and dictionaries: the values that hold others. Each can be written to and passed to a macro by reference. All
// walks over containers within containers are lists or loops: depth takes no stack.
#pragma once

#include "base/budget.h"
#include "interpreter/array_elements.h"
#include "interpreter/scopes.h"
#include "interpreter/shared.h"
#include "interpreter/value.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace isl::interpreter {

/// `array[d0][d1]…`: elements in row-major order.
struct ArrayValue final : Shared {
  ArrayValue(std::vector<std::size_t> dimensions, SlotPool& pool, Charge& account);
  ~ArrayValue() override;

  /// Bytes of an array of so many elements that are numbers or not set.
  [[nodiscard]] static std::size_t bytes_of(std::size_t elements);
  /// Makes an array of one dimension longer; its new elements are not set.
  void grow(std::size_t size);

  std::vector<std::size_t> dimensions;
  ArrayElements elements;
  bool grows = false;  ///< it was made without a size: an index beyond its end makes it longer
  SlotPool& pool;
  Charge& account;
};

/// `dictionary { .Name: value, … }`.
struct DictionaryValue final : Shared {
  DictionaryValue(SlotPool& pool_, Charge& account_);
  ~DictionaryValue() override;

  /// Bytes that one more value takes, without those that it points to.
  [[nodiscard]] static std::size_t bytes_of_field(std::string_view key);
  /// Null if there is no such key.
  [[nodiscard]] Slot* find(std::string_view key) const;
  /// The slot of the key, made if there is none.
  [[nodiscard]] Slot& add(std::string_view key);
  /// False if there is no such key.
  bool remove(std::string_view key);

  std::map<std::string, Slot*, std::less<>> fields;
  SlotPool& pool;
  Charge& account;
};

[[nodiscard]] inline bool is_container(const Value& value) {
  return value.kind() == ValueKind::array || value.kind() == ValueKind::dictionary;
}

/// The depth of containers within containers, counted up to `most`; 0 if the value is none.
[[nodiscard]] std::uint32_t container_depth(const Value& value, std::uint32_t most);

/// A copy of a container with slots of its own, as a declaration makes; so are the containers in it.
[[nodiscard]] Value copy_of_container(const Value& container);
/// Bytes that the copy takes.
[[nodiscard]] std::size_t bytes_of_copy(const Value& container);

}  // namespace isl::interpreter
