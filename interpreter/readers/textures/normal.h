// `normal { … }`: a pattern as bumps.
#pragma once

#include "interpreter/element_stream.h"
#include "interpreter/readers/textures/pigment.h"

namespace isl::interpreter {

/// Starts from `base` (kNoNormal: none), or from the identifier that the block begins with.
[[nodiscard]] scene::NormalId read_normal(Context& context, const Element& block, scene::NormalId base);
/// The same up to the end of the stream: the entry of a map has no braces of its own.
[[nodiscard]] scene::NormalId read_normal_body(ElementStream& stream, scene::NormalId base);

[[nodiscard]] scene::NormalId moved(Context& context, scene::NormalId normal, const scene::Transform& transform);
/// The same bumps with a height that transforms do not scale.
[[nodiscard]] scene::NormalId without_bump_scale(Context& context, scene::NormalId normal);

}  // namespace isl::interpreter
