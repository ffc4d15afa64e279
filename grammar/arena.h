// Memory for the nodes and strings of one scene's syntax trees: handed out in order, freed all at once.
//
// Nodes own nothing and are trivially destructible, so that freeing a tree of any depth frees a few blocks: no
// destructor walks it. The arena does not know the types that it stores.
#pragma once

#include "base/budget.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace isl::grammar {

/// Addresses stay valid until the arena dies. Not thread-safe.
class Arena {
 public:
  Arena() = default;
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  /// Every block is charged to the budget from here on, which outlives the arena: one that it does not have throws
  /// std::bad_alloc. Precondition: nothing was allocated.
  void set_budget(Budget* budget) { charge_ = Charge(budget); }

  /// Counts bytes that are stored elsewhere but live as long as the arena.
  void charge(std::size_t bytes) {
    if (!charge_.grow(bytes)) throw std::bad_alloc();
  }

  /// A copy of `value` that lives as long as the arena.
  template <class T>
  [[nodiscard]] T* create(T value) {
    static_assert(std::is_trivially_destructible_v<T>, "an arena runs no destructors");
    return new (allocate(sizeof(T), alignof(T))) T(std::move(value));
  }

  /// A copy of the elements; an empty span stays empty and costs nothing.
  template <class T>
  [[nodiscard]] std::span<const T> copy(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>, "an arena copies bytes");
    if (values.empty()) return {};
    void* const memory = allocate(values.size_bytes(), alignof(T));
    std::memcpy(memory, values.data(), values.size_bytes());
    return {static_cast<const T*>(memory), values.size()};
  }

  template <class T>
  [[nodiscard]] std::span<const T> copy(const std::vector<T>& values) {
    return copy(std::span<const T>(values));
  }

  [[nodiscard]] std::string_view copy_text(std::string_view text) {
    const std::span<const char> copied = copy(std::span<const char>(text.data(), text.size()));
    return {copied.data(), copied.size()};
  }

 private:
  /// Large enough that blocks are few, small enough that a ten-line scene does not notice.
  static constexpr std::size_t kBlockBytes = std::size_t{64} << 10;

  void* allocate(std::size_t bytes, std::size_t alignment) {
    void* at = next_;
    if (next_ == nullptr || std::align(alignment, bytes, at, left_) == nullptr) {
      const std::size_t block = std::max(kBlockBytes, bytes + alignment);
      charge(block);
      left_ = block;
      at = blocks_.emplace_back(std::make_unique<std::byte[]>(left_)).get();
      std::align(alignment, bytes, at, left_);
    }
    next_ = static_cast<std::byte*>(at) + bytes;
    left_ -= bytes;
    return at;
  }

  std::vector<std::unique_ptr<std::byte[]>> blocks_;
  std::byte* next_ = nullptr;
  std::size_t left_ = 0;
  Charge charge_;
};

}  // namespace isl::grammar
