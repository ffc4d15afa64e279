// Second semicolons. As in POV-Ray, the declaration of a number may end with two, and the second may also stand behind
// the end of what ends by declaring: so `#declare A = M();` can be read where M has a semicolon of its own, and `M();`
// where M's last item is a declaration. A declaration skips the first (directives.cpp), which costs the same whether a
// second follows or not; the second is only looked at where it is met.
#pragma once

#include "grammar/ast.h"
#include "interpreter/context.h"

namespace isl::interpreter {

/// The semicolon is such a second one and stands for nothing.
[[nodiscard]] bool is_spare(Context& context, const grammar::Semicolon& semicolon);

}  // namespace isl::interpreter
