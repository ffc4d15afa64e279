// `interior { … }`: the medium that fills an object.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

/// Starts from the identifier that the block begins with, or POV-Ray's default. Equal interiors share a record.
[[nodiscard]] scene::InteriorId read_interior(Context& context, const Element& block);
[[nodiscard]] scene::InteriorId interior_id(Context& context, const scene::Interior& interior);

}  // namespace isl::interpreter
