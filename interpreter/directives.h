// The directives without control flow: they change names and settings, include other files, or print messages.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// Executes any directive; #if, loops and #switch go on to interpreter/control.h. `#include` pushes the file's frame.
void execute(Context& context, const grammar::Node& node);

/// Executes a #declare or #local in a routine (interpreter/routines), which passes its semicolon itself.
void declare_in_routine(Context& context, const grammar::Declare& node);

}  // namespace isl::interpreter
