// `camera { … }`.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

/// Reads the block item by item, as POV-Ray does: `look_at`, `angle` and the vectors act on the items before them.
[[nodiscard]] Ref<CameraValue> read_camera(Context& context, const Element& block);

}  // namespace isl::interpreter
