// Which of the reserved words mean something here. Any other is POV-Ray's, and "not supported" rather than
// "unexpected".
#pragma once

#include "grammar/symbols.h"

namespace isl::interpreter {

[[nodiscard]] bool is_supported_word(grammar::Symbol word);

}  // namespace isl::interpreter
