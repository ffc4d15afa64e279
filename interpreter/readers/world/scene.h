// The statements at the top level of a scene.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

/// Executes a whole file and puts its objects and settings into the database. After an error it goes on with the next
/// statement.
void read_scene(Context& context, const grammar::Unit& unit);

/// `#default { texture {} … }`.
void read_default(Context& context, grammar::Items items, SourceSpan span);

/// Sets the texture with which objects begin to that of the version in force, unless the scene has stated one: white
/// without ambient light since 3.8, black with a tenth of it before.
void follow_version(Context& context);

}  // namespace isl::interpreter
