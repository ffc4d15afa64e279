// One column of the database while it is pruned (interpreter/prune.h).
#pragma once

#include "renderer/scene/ids.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace isl::interpreter {

/// First marks the reached records of a column, then maps them to their new numbers.
class Column {
 public:
  void resize(std::size_t size) { places_.assign(size, scene::kNone); }

  /// True the first time.
  bool reach(std::uint32_t i) {
    const bool is_new = places_[i] == scene::kNone;
    places_[i] = 0;
    return is_new;
  }
  [[nodiscard]] std::uint32_t place(std::uint32_t i) const { return places_[i]; }

  /// Keeps only the reached records.
  template <class Record>
  void compact(std::vector<Record>& records) {
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
      if (places_[i] == scene::kNone) continue;
      places_[i] = next;
      if (next != i) records[next] = std::move(records[i]);
      ++next;
    }
    records.resize(next);
  }

 private:
  std::vector<std::uint32_t> places_;
};

}  // namespace isl::interpreter
