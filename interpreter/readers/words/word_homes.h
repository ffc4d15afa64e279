// Which block each of the language's words stands in: for the message about a word that stands in another.
#pragma once

#include "interpreter/element_stream.h"

#include <string>

namespace isl::interpreter {

/// What to do about an element that means nothing in the block `stream_word` (kNoSymbol: the top level), or empty.
[[nodiscard]] std::string hint_for_misplaced(Context& context, const Element& element, grammar::Symbol stream_word);

}  // namespace isl::interpreter
