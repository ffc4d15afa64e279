// A vector for the long columns of a scene, which grow one record at a time and whose length is not known in advance.
// It grows by realloc, which moves the pages of large blocks instead of copying them. With std::vector half the time of
// making a blob of 10⁵ components went into touching memory that the next doubling gave up again.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace isl {

/// Opt-in trait: the type is trivially relocatable (its bytes may be copied and the old ones forgotten) although it has
/// a copy constructor.
template <class T>
inline constexpr bool kMovesAsBytes = std::is_trivially_copyable_v<T>;

/// The part of std::vector's interface that the scene's columns need. Throws std::bad_alloc.
template <class T>
class GrowingArray {
  static_assert(alignof(T) <= alignof(std::max_align_t));
  static_assert(std::is_trivially_destructible_v<T>);

 public:
  using value_type = T;
  using iterator = T*;
  using const_iterator = const T*;

  GrowingArray() = default;
  explicit GrowingArray(std::span<const T> records) {
    reserve(records.size());
    for (const T& record : records) push_back(record);
  }
  GrowingArray(std::initializer_list<T> records) : GrowingArray(std::span(records.begin(), records.size())) {}
  GrowingArray(const GrowingArray& other) : GrowingArray(std::span(other.begin(), other.size())) {}
  GrowingArray(GrowingArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)),
        size_(std::exchange(other.size_, 0)),
        capacity_(std::exchange(other.capacity_, 0)) {}
  GrowingArray& operator=(GrowingArray other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
    return *this;
  }
  ~GrowingArray() { std::free(data_); }

  void push_back(const T& record) {
    if (size_ == capacity_) [[unlikely]] {
      const T copy = record;  // NOLINT(performance-unnecessary-copy-initialization): the record may lie in the array
      reserve(capacity_ < 8 ? 16 : capacity_ + capacity_ / 2);
      new (data_ + size_++) T(copy);
    } else {
      new (data_ + size_++) T(record);
    }
  }
  void reserve(std::size_t capacity) {
    static_assert(kMovesAsBytes<T>);
    if (capacity <= capacity_) return;
    if (capacity > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_alloc();
    void* const moved = std::realloc(static_cast<void*>(data_), capacity * sizeof(T));
    if (moved == nullptr) throw std::bad_alloc();
    data_ = static_cast<T*>(moved);
    capacity_ = capacity;
  }
  /// New records are value-initialised (`T()`).
  void resize(std::size_t size) {
    reserve(size);
    while (size_ < size) new (data_ + size_++) T();
    size_ = size;
  }
  void clear() { size_ = 0; }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] T* data() { return data_; }
  [[nodiscard]] const T* data() const { return data_; }
  [[nodiscard]] T& operator[](std::size_t i) { return data_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return data_[i]; }
  [[nodiscard]] T& front() { return data_[0]; }
  [[nodiscard]] const T& front() const { return data_[0]; }
  [[nodiscard]] T& back() { return data_[size_ - 1]; }
  [[nodiscard]] const T& back() const { return data_[size_ - 1]; }
  [[nodiscard]] T* begin() { return data_; }
  [[nodiscard]] T* end() { return data_ + size_; }
  [[nodiscard]] const T* begin() const { return data_; }
  [[nodiscard]] const T* end() const { return data_ + size_; }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace isl
