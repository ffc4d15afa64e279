// `pigment { … }`: a colour, or a pattern that chooses colours from a map or list.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

/// Starts from `base`, or from the identifier that the block begins with.
[[nodiscard]] scene::Pigment read_pigment(Context& context, const Element& block, const scene::Pigment& base);
/// The same if `base` was moved while it was a plain colour: as in POV-Ray, a pattern that takes its place is moved in
/// the same way. Replaces `plain_moved` by what is true of the result.
[[nodiscard]] scene::Pigment read_pigment(Context& context, const Element& block, const scene::Pigment& base,
                                          scene::Transform& plain_moved);
/// The same up to the end of the stream: the entry of a map has no braces of its own.
[[nodiscard]] scene::Pigment read_pigment_body(ElementStream& stream, const scene::Pigment& base);

/// Any pigment as a record of the database.
[[nodiscard]] scene::PigmentId patterned_pigment(Context& context, const scene::Pigment& pigment);

/// A pigment that is evaluated at (u, v) of the surface stays unchanged.
[[nodiscard]] scene::Pigment moved(Context& context, const scene::Pigment& pigment, const scene::Transform& transform);

}  // namespace isl::interpreter
