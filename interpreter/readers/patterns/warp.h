// `warp { … }` and the words of turbulence, which occur in warps, patterns and effects' statements.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

[[nodiscard]] scene::Warp read_warp(Context& context, const Element& block);

/// Reads `turbulence`, `octaves`, `omega` or `lambda` if the next element is one.
[[nodiscard]] bool read_turbulence_item(ElementStream& stream, scene::Turbulence& turbulence);

}  // namespace isl::interpreter
