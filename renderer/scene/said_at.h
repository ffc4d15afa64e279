// The places of a record's items in the scene, for messages about an item. Places are no part of a record's value:
// records that differ only in them are equal.
#pragma once

#include "base/source_span.h"

#include <array>
#include <cstddef>

namespace isl::scene {

/// One place per item; unknown for items that the scene does not have. The last enumerator of Item is `count`.
template <class Item>
class SaidAt {
 public:
  [[nodiscard]] OriginId operator[](Item item) const { return places_[static_cast<std::size_t>(item)]; }
  OriginId& operator[](Item item) { return places_[static_cast<std::size_t>(item)]; }

 private:
  std::array<OriginId, static_cast<std::size_t>(Item::count)> places_{};
};

}  // namespace isl::scene
