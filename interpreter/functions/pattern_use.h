// What a function of a pattern or pigment rests on, looked up once when it is made: how deeply patterns stand in one
// another, and whether all of them can be evaluated. So that evaluating needs no counting and no complaints.
#pragma once

#include "interpreter/context.h"

#include <string_view>

namespace isl::interpreter {

struct PatternUse {
  std::uint32_t depth = 1;   ///< of patterns and pigments in one another, functions' included
  std::string_view missing;  ///< names one that cannot be evaluated; never owned; empty for none
};

// Each fails where they are nested deeper than functions may be.
[[nodiscard]] PatternUse use_of(Context& context, const scene::Pattern& pattern, SourceSpan span);
[[nodiscard]] PatternUse use_of(Context& context, const scene::Pigment& pigment, SourceSpan span);

}  // namespace isl::interpreter
