// The values allowed on the right of `#declare A =`, as a macro's argument or as an array's element.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

/// One value from the stream: an expression, a colour in any form, or a block that makes a value.
[[nodiscard]] Value read_rvalue(ElementStream& stream);
/// The same if its first expression was already taken: `Red transmit .5` after `Red`.
[[nodiscard]] Value read_rvalue_after(ElementStream& stream, Value first);
/// The same for #declare, where a run of texture blocks is one value.
[[nodiscard]] Value read_declared(ElementStream& stream);
/// The texture with the texture blocks that come next in the stream as layers over it.
[[nodiscard]] Value with_layers(ElementStream& stream, Value value);

}  // namespace isl::interpreter
