// Readers of the part of a pattern that is not common to all patterns: the operands that the descriptor of each kind
// declares, and the content of the block of a pattern that is one.
#pragma once

#include "interpreter/element_stream.h"

#include <string_view>

namespace isl::interpreter {

/// Reads the operands after the word of a pattern, or in its block, into `pattern.operands`, which hold the defaults.
void read_operands(ElementStream& stream, scene::Pattern& pattern, std::string_view word);

/// `function { … }` is one value of the stream.
[[nodiscard]] bool is_function(const Element& element);
/// Reads it; fails if the next element is something else.
[[nodiscard]] scene::FunctionId read_function_operand(ElementStream& stream);

/// Reads an operand that has a word of its own if the next element is one; fails if
/// the word belongs to another pattern.
[[nodiscard]] bool read_operand_modifier(ElementStream& stream, scene::Pattern& pattern);

/// Fails where operands do not go together. For whoever has read all of the pattern; `stream` says where.
void check_operands(ElementStream& stream, const scene::Pattern& pattern);

}  // namespace isl::interpreter
