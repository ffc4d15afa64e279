// What an object's modifiers say of its looks: texture, interior_texture, interior, material, and the pigment, normal
// and finish that stand there without a texture around them.
#pragma once

#include "interpreter/element_stream.h"

#include <optional>

namespace isl::interpreter {

/// Reads one of the blocks into `surface` if the next element is one. What moves the object afterwards moves its
/// textures too, so they are kept in the object's space: `parent_from_object` is where the object stands by now, and
/// they are taken back by it.
[[nodiscard]] bool read_surface_modifier(ElementStream& stream, Surface& surface,
                                         const scene::Transform& parent_from_object = {});

/// pigment, normal, finish or texture alone: what a component and #default take.
[[nodiscard]] bool read_texture_modifier(ElementStream& stream, std::optional<scene::Texture>& texture,
                                         const scene::Transform& parent_from_object = {});

/// The whole of `material { … }`: the identifier it begins with, textures, an interior, transforms.
[[nodiscard]] Surface read_material(Context& context, const Element& block);

}  // namespace isl::interpreter
