// `dictionary { .Name: value, ["key"]: value }`: making dictionaries. What their values are called elsewhere in a scene
// is a place (interpreter/places.h).
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

[[nodiscard]] Value make_dictionary(Context& context, const grammar::Dictionary& node);

}  // namespace isl::interpreter
