// The default colours of POV-Ray's patterns.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// The map of a pattern that takes one: black to white for most.
[[nodiscard]] scene::PigmentMapId default_pigment_map(Context& context, const scene::Pattern& pattern);

/// The items of a block pattern.
[[nodiscard]] scene::PigmentMap default_pigment_list(scene::PatternKind kind);
/// The same list as a record in the database, made once per scene.
[[nodiscard]] scene::PigmentMapId default_pigment_list_id(Context& context, scene::PatternKind kind);

}  // namespace isl::interpreter
