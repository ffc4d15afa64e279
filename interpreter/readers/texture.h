// pigment, finish, texture: as blocks that make a value, and as modifiers of an object or a blob's component.
#pragma once

#include "interpreter/element_stream.h"

#include <optional>

namespace isl::interpreter {

/// Each starts from `base`, or from the identifier that the block begins with.
[[nodiscard]] scene::Pigment read_pigment(Context& context, const Element& block, const scene::Pigment& base);
[[nodiscard]] scene::Finish read_finish(Context& context, const Element& block, const scene::Finish& base);
[[nodiscard]] scene::Texture read_texture(Context& context, const Element& block, const scene::Texture& base);

/// A texture laid over another. Only an opaque one can be, since it hides what is below.
[[nodiscard]] scene::Texture layered(Context& context, const scene::Texture& top, SourceSpan span);

/// Reads one of the three blocks into `texture` if the next element is one. `texture` is empty as long as nothing was
/// said; then the first block starts from the scene's default.
[[nodiscard]] bool read_texture_modifier(ElementStream& stream, std::optional<scene::Texture>& texture);

/// The texture's number in the database; equal textures share one.
[[nodiscard]] scene::TextureId texture_id(Context& context, const scene::Texture& texture);

}  // namespace isl::interpreter
