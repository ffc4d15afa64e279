// `translate`, `rotate`, `scale`, `matrix`, `transform`: the modifiers that move things.
#pragma once

#include "interpreter/element_stream.h"

#include <optional>

namespace isl::interpreter {

/// Reads one transform if the next element is one. A singular map is an error; a scale of zero is replaced by one with
/// a warning, as in POV-Ray.
[[nodiscard]] std::optional<scene::Transform> read_transform(ElementStream& stream);
/// `first`, then `next`, which is written at `span`: the place of an object or component. Warns if the composition
/// loses digits that the two have.
[[nodiscard]] scene::Transform then_placed(Context& context, SourceSpan span, const scene::Transform& first,
                                           const scene::Transform& next);
/// Reads the whole of `transform { … }`: applied in order, then inverted if it says `inverse`.
[[nodiscard]] scene::Transform read_transform_block(Context& context, const Element& block);

}  // namespace isl::interpreter
