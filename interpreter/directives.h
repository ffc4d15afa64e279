// The directives without control flow: they change names and settings, include other files, or print messages.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// Executes any directive; #if, loops and #switch go on to interpreter/control.h. `#include` pushes the file's frame.
void execute(Context& context, const grammar::Node& node);

}  // namespace isl::interpreter
