// POV-Ray's words for features that are not supported here: the message is "not supported" rather than "unexpected".
#pragma once

#include "grammar/symbols.h"

namespace isl::interpreter {

/// True for words that begin a construct; words that occur only inside an unsupported one are skipped with it.
[[nodiscard]] bool is_unsupported_word(grammar::Symbol word);
/// True for those of them that make an object.
[[nodiscard]] bool is_unsupported_object(grammar::Symbol word);

}  // namespace isl::interpreter
