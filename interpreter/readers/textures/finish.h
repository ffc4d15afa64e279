// `finish { … }`: the surface's response to light.
#pragma once

#include "interpreter/element_stream.h"

#include <vector>

namespace isl::interpreter {

/// Starts from `base`, or from the identifier that the block begins with.
[[nodiscard]] scene::Finish read_finish(Context& context, const Element& block, const scene::Finish& base);

/// The words of its items.
[[nodiscard]] std::vector<grammar::Symbol> finish_words(Context& context);

/// The finish's number in the database; equal finishes share one, and POV-Ray's default is kDefaultFinish.
[[nodiscard]] scene::FinishId finish_id(Context& context, const scene::Finish& finish);

}  // namespace isl::interpreter
