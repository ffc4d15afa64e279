// `texture { … }`: a pigment with a normal and a finish, or a choice of other textures; and layers of them.
#pragma once

#include "interpreter/element_stream.h"
#include "interpreter/readers/textures/pigment.h"

namespace isl::interpreter {

/// Starts from `base`, or from the identifier that the block begins with.
[[nodiscard]] scene::Texture read_texture(Context& context, const Element& block, const scene::Texture& base);
/// The same. Sets `plain_moved` to how its pigment was moved while it was a plain colour (read_pigment).
[[nodiscard]] scene::Texture read_texture(Context& context, const Element& block, const scene::Texture& base,
                                          scene::Transform& plain_moved);
/// The same up to the end of the stream: the entry of a map has no braces of its own.
[[nodiscard]] scene::Texture read_texture_body(ElementStream& stream, const scene::Texture& base);

/// `top`, which may be layers itself, laid over `below`. Fails for textures that a pattern chooses.
[[nodiscard]] scene::Texture layered(Context& context, const scene::Texture& below, const scene::Texture& top,
                                     SourceSpan span);

/// The texture with all its parts moved.
[[nodiscard]] scene::Texture moved(Context& context, const scene::Texture& texture, const scene::Transform& transform);

/// The texture with bumps whose height transforms do not scale.
[[nodiscard]] scene::Texture without_bump_scale(Context& context, const scene::Texture& texture);

/// The texture with every layer evaluated at (u, v) of the surface.
[[nodiscard]] scene::Texture uv_mapped(Context& context, const scene::Texture& texture);

/// The texture's number in the database; equal textures share one.
[[nodiscard]] scene::TextureId texture_id(Context& context, const scene::Texture& texture);

/// The finish of the texture as the scene wrote it.
[[nodiscard]] inline scene::Finish finish_of(const Context& context, const scene::Texture& texture) {
  return context.database.finish(texture.finish);
}

}  // namespace isl::interpreter
