// Macro calls: the callee, its actual arguments, and the frame that executes its body.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// The macro, function or spline that `call` calls; fails for another callee. The value is a variable's: evaluating
/// anything may change it.
[[nodiscard]] const Value& called(Context& context, const grammar::Call& call);

/// Evaluates the arguments of `call` in the caller's scope, pushes the frame that executes the macro's body, and binds
/// the parameters in its scope: a lone identifier to the caller's own slot (by reference), everything else to a new
/// one. The macro may be a variable's: it is not read after arguments are evaluated.
void push_macro(Context& context, const grammar::Call& call, const MacroValue& macro);

/// The same for a macro whose body is the given routine, which is run to its end.
void call_routine(Context& context, const grammar::Call& call, const MacroValue& macro, const Routine& routine);
/// The same for a call whose value is wanted; fails with the message `without_value` if it yields none.
void call_routine(Context& context, const grammar::Call& call, const MacroValue& macro, const Routine& routine,
                  const char* without_value, Value& result);

}  // namespace isl::interpreter
