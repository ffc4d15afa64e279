// Compares a camera's `right` with the shape of the picture. If they differ, the picture is stretched.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// Warns at `span` if the picture's size is known and the camera would stretch it, and says which `right` fits.
void check_shape(Context& context, const scene::Camera& camera, SourceSpan span);

}  // namespace isl::interpreter
