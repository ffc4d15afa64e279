// Does a camera's `right` fit the shape of the picture? Where it does not, what it shows is stretched.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// Warns at `span` where the picture's size is known and the camera would stretch it, and says which `right` fits.
void check_shape(Context& context, const scene::Camera& camera, SourceSpan span);

}  // namespace isl::interpreter
