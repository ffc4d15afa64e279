// `#declare (A, B) = (1, "two");`: several places from one tuple of values, which may be all that a macro yields.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

void declare_tuple(Context& context, const grammar::DeclareTuple& node);

}  // namespace isl::interpreter
