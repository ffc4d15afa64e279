// Where a scene says an item of a record: what a message points at that is about the item. Places say nothing of what a record is, so
// records that differ in them alone are equal.
#pragma once

#include "base/source_span.h"

#include <array>
#include <cstddef>

namespace isl::scene {

/// By item; unknown for those that the scene does not say. The last enumerator of Item is `count`.
template <class Item>
class SaidAt {
 public:
  [[nodiscard]] OriginId operator[](Item item) const { return places_[static_cast<std::size_t>(item)]; }
  OriginId& operator[](Item item) { return places_[static_cast<std::size_t>(item)]; }

 private:
  std::array<OriginId, static_cast<std::size_t>(Item::count)> places_{};
};

}  // namespace isl::scene
