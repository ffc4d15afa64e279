// Loops and macros that run as routines. Everything else has the evaluator's frames (interpreter/frames.h).
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// Runs the #while or #for to its end, if it can be a routine. False: nothing was done.
[[nodiscard]] bool run_loop(Context& context, const grammar::Node& loop);

/// The routine of the macro's body; null if it cannot be one.
[[nodiscard]] const Routine* routine_of(Context& context, const MacroValue& macro);

/// Runs a macro's body in the frame and scope that were opened for it. True if it yields a value, which is in `result`.
bool run_body(Context& context, const Routine& routine, Value& result);

}  // namespace isl::interpreter
