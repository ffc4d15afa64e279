// Notes the places of those items whose places a record keeps (renderer/scene/said_at.h).
#pragma once

#include "interpreter/element_stream.h"
#include "renderer/scene/said_at.h"

#include <cstddef>

namespace isl::interpreter {

/// The place that messages about the element point to: its word; for a block its first word.
[[nodiscard]] inline OriginId place_of(Context& context, const Element& element) {
  return context.origin(element.is(ElementKind::block) ? element.word_span : element.span);
}

template <class Item>
struct ItemWord {
  grammar::Symbol word;
  Item item;
};

/// Called with each element that begins an item; does nothing for items whose places are not kept.
template <class Item, std::size_t count>
void note_place(Context& context, const Element& element, const ItemWord<Item> (&words)[count],
                scene::SaidAt<Item>& said_at) {
  if (!element.is(ElementKind::word) && !element.is(ElementKind::block)) return;
  for (const ItemWord<Item>& row : words) {
    if (row.word == element.word) said_at[row.item] = place_of(context, element);
  }
}

}  // namespace isl::interpreter
