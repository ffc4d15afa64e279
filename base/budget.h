// The memory of one run: a limit that every part of the program charges before it allocates, so that a scene that would
// take more is refused instead of filling the machine. Memory is what is charged here; the system's limits of address
// space are no substitute, because a process reserves several times the addresses that it uses.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <utility>

namespace isl {

/// Bytes that the parts of one run hold together, and how many they may hold. Any thread may call every member.
class Budget {
 public:
  explicit Budget(std::size_t limit = std::numeric_limits<std::size_t>::max()) : limit_(limit) {}
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  /// Takes the bytes and returns true, or takes none and returns false if fewer are left.
  [[nodiscard]] bool take(std::size_t bytes) noexcept {
    std::size_t held = held_.load(std::memory_order_relaxed);
    do {
      if (bytes > limit_ - held) return false;
    } while (!held_.compare_exchange_weak(held, held + bytes, std::memory_order_relaxed));
    return true;
  }
  /// Returns bytes that take() gave.
  void give_back(std::size_t bytes) noexcept { held_.fetch_sub(bytes, std::memory_order_relaxed); }

  [[nodiscard]] std::size_t limit() const noexcept { return limit_; }
  [[nodiscard]] std::size_t held() const noexcept { return held_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::size_t left() const noexcept { return limit_ - held(); }

 private:
  const std::size_t limit_;
  std::atomic<std::size_t> held_ = 0;  ///< never more than limit_
};

/// The bytes that one owner holds of a budget, which gets them back when the owner dies. They are taken from the budget
/// in blocks, so that counting something small is an addition. Without a budget everything is granted. Not thread-safe:
/// threads that share work have a charge each.
class Charge {
 public:
  Charge() = default;
  explicit Charge(Budget* budget) : budget_(budget) {}
  Charge(Charge&& other) noexcept
      : budget_(std::exchange(other.budget_, nullptr)),
        used_(std::exchange(other.used_, 0)),
        taken_(std::exchange(other.taken_, 0)) {}
  Charge& operator=(Charge&& other) noexcept {
    std::swap(budget_, other.budget_);
    std::swap(used_, other.used_);
    std::swap(taken_, other.taken_);
    return *this;
  }
  ~Charge() {
    if (budget_ != nullptr) budget_->give_back(taken_);
  }

  /// Called before an allocation: counts the bytes and returns true, or counts none and returns false if the budget
  /// does not have them.
  [[nodiscard]] bool grow(std::size_t bytes) noexcept {
    if (!make_room(bytes)) return false;
    used_ += bytes;
    return true;
  }
  /// True if the next bytes can be added. Their owner then calls add().
  [[nodiscard]] bool make_room(std::size_t bytes) noexcept {
    if (used_ <= taken_ && bytes <= taken_ - used_) [[likely]]
      return true;
    return budget_ == nullptr || take(bytes);
  }
  /// Counts bytes that are allocated in any case. Bytes beyond the room made are taken at the next call of make_room().
  void add(std::size_t bytes) noexcept { used_ += bytes; }
  /// Counts bytes as freed. Some stay with this charge, because they will be needed again.
  void remove(std::size_t bytes) noexcept {
    used_ -= bytes;
    if (budget_ != nullptr && taken_ > used_ && taken_ - used_ > kSpareBytes) [[unlikely]]
      give_back_spare();
  }

  [[nodiscard]] std::size_t bytes() const noexcept { return used_; }

 private:
  /// Large enough that the budget's counter is seldom touched, small beside any limit that is useful. An owner of less
  /// takes no more than twice what it holds.
  static constexpr std::size_t kBlockBytes = std::size_t{64} << 10;
  static constexpr std::size_t kSpareBytes = 16 * kBlockBytes;

  [[nodiscard]] bool take(std::size_t bytes) noexcept {
    if (bytes > std::numeric_limits<std::size_t>::max() / 2 - used_) return false;
    const std::size_t missing = used_ + bytes - taken_;
    for (const std::size_t wanted : {missing + std::min(used_, kBlockBytes), missing}) {
      if (!budget_->take(wanted)) continue;
      taken_ += wanted;
      return true;
    }
    return false;
  }
  void give_back_spare() noexcept {
    const std::size_t spare = taken_ - used_ - kBlockBytes;
    budget_->give_back(spare);
    taken_ -= spare;
  }

  Budget* budget_ = nullptr;
  std::size_t used_ = 0;   ///< counted by the owner
  std::size_t taken_ = 0;  ///< taken from the budget; less than used_ only between add() and make_room()
};

}  // namespace isl
