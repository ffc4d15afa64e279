// Makes routines from the tree.
#pragma once

#include "interpreter/routines/routine.h"

#include <optional>

namespace isl::interpreter {

/// A routine for a loop; none if something in it is more than declarations, conditions and loops.
[[nodiscard]] std::optional<Routine> routine_of_loop(Context& context, const grammar::Node& loop);

/// The same for a macro's body, whose last item, or the last of a branch that ends it, may be the value that it yields.
[[nodiscard]] std::optional<Routine> routine_of_macro(Context& context, const grammar::Macro& macro);

}  // namespace isl::interpreter
