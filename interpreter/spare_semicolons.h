// Second semicolons. As in POV-Ray, the declaration of a number may end with two, and the second may also follow the
// end of a construct that ends by declaring: so `#declare A = M();` can be read if M has a semicolon of its own, and
// `M();` if M's last item is a declaration. A declaration skips the first (directives.cpp), which costs the same with
// and without a second; the second is only examined where it is met.
#pragma once

#include "grammar/ast.h"
#include "interpreter/context.h"

namespace isl::interpreter {

/// True if the semicolon is such a second one, which has no meaning.
[[nodiscard]] bool is_spare(Context& context, const grammar::Semicolon& semicolon);

}  // namespace isl::interpreter
