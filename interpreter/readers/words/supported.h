// Which of POV-Ray's words mean something that is not here: "not supported" rather than "unexpected".
#pragma once

#include "grammar/symbols.h"

namespace isl::interpreter {

/// Of words that begin a construct; those that stand only inside one that is not supported are skipped with it.
[[nodiscard]] bool is_unsupported_word(grammar::Symbol word);
/// Those that make an object.
[[nodiscard]] bool is_unsupported_object(grammar::Symbol word);

}  // namespace isl::interpreter
