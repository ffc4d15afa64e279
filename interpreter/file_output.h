// The bytes that `#write` makes of a value: POV-Ray's spelling of numbers and vectors, and its binary forms. Knows no
// file.
#pragma once

#include "interpreter/element_stream.h"

#include <string>

namespace isl::interpreter {

/// The next value of the stream, or the next binary form with its value (`sint16be V`), as bytes. Numbers are `%g`,
/// vectors `<a,b,c> ` with a space after them; strings are written unchanged.
[[nodiscard]] std::string read_output(ElementStream& stream);

}  // namespace isl::interpreter
