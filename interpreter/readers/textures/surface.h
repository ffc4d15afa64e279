// The modifiers of an object's look: texture, interior_texture, interior, material, and pigment, normal and finish
// without a texture around them.
#pragma once

#include "interpreter/element_stream.h"

#include <optional>

namespace isl::interpreter {

/// Reads one of the blocks into `surface` if the next element is one. Later transforms of the object move its textures
/// too, so they are kept in the object's space: `parent_from_object` is the object's present placement, and its inverse
/// is applied to them.
[[nodiscard]] bool read_surface_modifier(ElementStream& stream, Surface& surface,
                                         const scene::Transform& parent_from_object = {});

/// Reads pigment, normal, finish or texture alone into the surface, for a component and for #default.
[[nodiscard]] bool read_texture_modifier(ElementStream& stream, Surface& surface,
                                         const scene::Transform& parent_from_object = {});

/// Reads the whole of `material { … }`: the identifier it begins with, textures, an interior, transforms.
[[nodiscard]] Surface read_material(Context& context, const Element& block);

}  // namespace isl::interpreter
