// The block to which each of the language's words belongs, for the message about a word in the wrong block.
#pragma once

#include "interpreter/element_stream.h"

#include <string>

namespace isl::interpreter {

/// The remedy for an element without a meaning in the block `stream_word` (kNoSymbol: the top level), or empty.
[[nodiscard]] std::string hint_for_misplaced(Context& context, const Element& element, grammar::Symbol stream_word);

}  // namespace isl::interpreter
