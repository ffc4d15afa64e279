// Finds equal records of a column, so that a thousand spheres of one colour share one texture.
#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace isl::interpreter {

/// Record: a plain struct without padding (its bytes are compared).
template <class Record>
class RecordTable {
 public:
  /// The index in `records` of one that is bitwise equal except for its places; appended if there is none.
  [[nodiscard]] std::uint32_t find_or_add(const Record& record, std::vector<Record>& records) {
    // Consecutive objects of a scene mostly share their records.
    if (last_ < records.size() && is_same(records[last_], record)) return last_;
    const auto next = static_cast<std::uint32_t>(records.size());
    const Record plain = without_places(record);
    const std::size_t hash = std::hash<std::string_view>()(bytes(plain));
    const auto [first, end] = by_hash_.equal_range(hash);
    for (auto it = first; it != end; ++it) {
      if (is_same(records[it->second], record)) return last_ = it->second;
    }
    by_hash_.emplace(hash, next);
    records.push_back(record);
    return last_ = next;
  }

  /// Compares bits: records that differ only in padding or in the sign of a zero are kept twice, which is harmless.
  [[nodiscard]] static bool is_same(const Record& a, const Record& b) {
    const Record plain_a = without_places(a), plain_b = without_places(b);
    return std::memcmp(&plain_a, &plain_b, sizeof(Record)) == 0;  // NOLINT(bugprone-suspicious-memory-comparison)
  }

 private:
  static_assert(std::is_trivially_copyable_v<Record> && sizeof(Record) % sizeof(double) == 0);
  [[nodiscard]] static std::string_view bytes(const Record& record) {
    return {reinterpret_cast<const char*>(&record), sizeof(record)};
  }

  std::unordered_multimap<std::size_t, std::uint32_t> by_hash_;
  std::uint32_t last_ = 0;
};

}  // namespace isl::interpreter
