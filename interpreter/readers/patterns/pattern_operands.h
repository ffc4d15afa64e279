// The operands of single patterns, beside the modifiers of all: the numbers after their words, and words of their own.
// One row a pattern in the table of pattern.cpp.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

/// Reads the operands after a pattern's word (or in its block) into `pattern.operands`.
using ReadOperands = void (*)(ElementStream& stream, scene::Pattern& pattern);

// Patterns whose operands are modifiers: these functions set the defaults.
void begin_agate(ElementStream& stream, scene::Pattern& pattern);
void begin_brick(ElementStream& stream, scene::Pattern& pattern);
void begin_crackle(ElementStream& stream, scene::Pattern& pattern);
void begin_facets(ElementStream& stream, scene::Pattern& pattern);
void begin_pavement(ElementStream& stream, scene::Pattern& pattern);
void begin_quilted(ElementStream& stream, scene::Pattern& pattern);

void read_density_file(ElementStream& stream, scene::Pattern& pattern);
void read_gradient(ElementStream& stream, scene::Pattern& pattern);
void read_image_operand(ElementStream& stream, scene::Pattern& pattern);
void read_julia(ElementStream& stream, scene::Pattern& pattern);
void read_magnet(ElementStream& stream, scene::Pattern& pattern);
void read_mandel(ElementStream& stream, scene::Pattern& pattern);
void read_object_operand(ElementStream& stream, scene::Pattern& pattern);
void read_pigment_operand(ElementStream& stream, scene::Pattern& pattern);
void read_slope(ElementStream& stream, scene::Pattern& pattern);
void read_spiral(ElementStream& stream, scene::Pattern& pattern);
void read_tiling(ElementStream& stream, scene::Pattern& pattern);

/// `function { … }` as a value of the stream.
[[nodiscard]] scene::FunctionId read_function_operand(ElementStream& stream);

/// Reads a word that only this pattern has (`agate_turb`, `brick_size` …) if the next element is one; fails if the word
/// belongs to another pattern.
[[nodiscard]] bool read_operand_modifier(ElementStream& stream, scene::Pattern& pattern);

}  // namespace isl::interpreter
