// Maps and lists: the values that a pattern chooses from. `color_map { [0 rgb 1] [1 rgb 0] }` and related blocks, and
// the items of block patterns (`checker A, B`).
#pragma once

#include "interpreter/element_stream.h"
#include "renderer/patterns/kinds/pattern_kind.h"

namespace isl::interpreter {

/// An entry's value can be left out only where it is a weight of a mean; the weight is then 1.
enum class EntryValue { needed, optional };
[[nodiscard]] inline EntryValue entry_value(scene::PatternKind kind) {
  return render::info_of(kind).choice == render::PatternChoice::mean_of_map ? EntryValue::optional : EntryValue::needed;
}

// Each reads a whole block: entries, or the identifier of a map of its kind.
[[nodiscard]] scene::PigmentMapId read_colour_map(Context& context, const Element& block);
[[nodiscard]] scene::PigmentMapId read_pigment_map(Context& context, const Element& block, EntryValue value);
[[nodiscard]] scene::NormalMapId read_normal_map(Context& context, const Element& block, EntryValue value);
[[nodiscard]] scene::SlopeMapId read_slope_map(Context& context, const Element& block);
[[nodiscard]] scene::TextureMapId read_texture_map(Context& context, const Element& block, EntryValue value);

// Each reads the items that follow a block pattern's word, at most `count`; POV-Ray's defaults replace missing ones.
// A list of normals without an item gives kNoNormalMap.
[[nodiscard]] scene::PigmentMapId read_pigment_list(ElementStream& stream, scene::PatternKind kind, int count);
[[nodiscard]] scene::NormalMapId read_normal_list(ElementStream& stream, int count);
[[nodiscard]] scene::TextureMapId read_texture_list(ElementStream& stream, int count);

}  // namespace isl::interpreter
