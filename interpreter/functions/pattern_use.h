// The properties of a pattern or pigment that a function needs, computed once when it is made: the depth of nested
// patterns, and whether all of them can be evaluated. So evaluation needs no counting and reports no errors.
#pragma once

#include "interpreter/context.h"

#include <string_view>

namespace isl::interpreter {

struct PatternUse {
  std::uint32_t depth = 1;   ///< nesting depth of patterns and pigments, functions' included
  std::string_view missing;  ///< names one that cannot be evaluated; never owned; empty for none
};

// Each fails if they are deeper than values may be.
[[nodiscard]] PatternUse use_of(Context& context, const scene::Pattern& pattern, SourceSpan span);
[[nodiscard]] PatternUse use_of(Context& context, const scene::Pigment& pigment, SourceSpan span);

}  // namespace isl::interpreter
