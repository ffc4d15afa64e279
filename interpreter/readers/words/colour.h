// Colours in every form that POV-Ray has: `rgb <1,0,0>`, `color red 1 green .5`, `srgbft …`, an identifier with
// overrides. Values are in the scene's working space (assumed_gamma); `srgb` forms are converted to it.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

/// True for a word that may begin a colour: color, rgb, red, …
[[nodiscard]] bool is_colour_word(grammar::Symbol word);
/// True for a word that overrides one component: red, green, blue, filter, transmit.
[[nodiscard]] bool is_colour_component(const Element& element);

[[nodiscard]] scene::Colour read_colour(ElementStream& stream);
/// Reads the overrides after a colour that was already taken.
[[nodiscard]] Value read_colour_after(ElementStream& stream, const Value& colour);

[[nodiscard]] Value to_value(const scene::Colour& colour);
/// Promotes as POV-Ray does: a number fills all five, a shorter vector is padded with zeros.
[[nodiscard]] scene::Colour to_colour(const Value& value);

}  // namespace isl::interpreter
