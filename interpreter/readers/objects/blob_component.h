// The geometry of a blob's components: POV-Ray's `sphere` and `cylinder`, and, with a kernel in force, the solids that
// are skeletons.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

/// True if the word begins a component's block.
[[nodiscard]] bool is_component_word(grammar::Symbol word);

/// The words of all components, for suggestions.
[[nodiscard]] std::span<const grammar::Symbol> component_words();

/// The radius of the support of one of POV-Ray's components, which squares it: the sign has no meaning. A radius of 0
/// is warned of.
[[nodiscard]] double read_support_radius(ElementStream& stream);

/// Reads the skeleton and its radii from the block's stream. `kernel`: the one in force, null if there is none; without
/// one only POV-Ray's components are known. `blob` stores data that does not fit into the component's record.
[[nodiscard]] scene::Component read_component_shape(ElementStream& stream, const Element& block,
                                                    const scene::Kernel* kernel, scene::Blob& blob);

}  // namespace isl::interpreter
