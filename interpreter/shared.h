// Intrusively counted objects that values point to, immutable while they are shared. One evaluation runs on one thread,
// so the count is a plain integer. Knows nothing of the language.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

namespace isl::interpreter {

/// Base class of everything that values may share.
class Shared {
 public:
  Shared() = default;
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;
  virtual ~Shared() = default;

 private:
  template <class T>
  friend class Ref;
  // Out of line: frees are rare, and inlined code makes g++ 12 warn of a use after free that the count excludes.
  [[gnu::noinline]] static void destroy(const Shared* shared) { delete shared; }
  std::uint32_t references_ = 0;
};

/// A counted pointer to a Shared; may be null.
template <class T>
class Ref {
 public:
  Ref() = default;
  explicit Ref(T* target) : target_(target) { retain(); }
  Ref(const Ref& other) : target_(other.target_) { retain(); }
  Ref(Ref&& other) noexcept : target_(std::exchange(other.target_, nullptr)) {}
  Ref& operator=(Ref other) noexcept {
    std::swap(target_, other.target_);
    return *this;
  }
  ~Ref() { release(); }

  template <class U>
  requires std::is_convertible_v<T*, U*>
  operator Ref<U>() const {  // NOLINT(google-explicit-constructor): as a pointer converts to its base
    return Ref<U>(target_);
  }

  [[nodiscard]] T* get() const { return target_; }
  [[nodiscard]] T& operator*() const { return *target_; }
  [[nodiscard]] T* operator->() const { return target_; }
  [[nodiscard]] explicit operator bool() const { return target_ != nullptr; }
  /// True if no other Ref points to it; it is not null.
  [[nodiscard]] bool is_only() const { return static_cast<Shared*>(target_)->references_ == 1; }

 private:
  void retain() const {
    if (target_) ++static_cast<Shared*>(target_)->references_;
  }
  void release() {
    if (target_ && --static_cast<Shared*>(target_)->references_ == 0) Shared::destroy(target_);
  }

  T* target_ = nullptr;
};

template <class T, class... Arguments>
[[nodiscard]] Ref<T> make_shared_value(Arguments&&... arguments) {
  return Ref<T>(new T(std::forward<Arguments>(arguments)...));
}

}  // namespace isl::interpreter
