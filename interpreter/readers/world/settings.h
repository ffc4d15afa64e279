// `global_settings { … }` and `background { … }`.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

void read_global_settings(Context& context, const Element& block);
void read_background(Context& context, const Element& block);

}  // namespace isl::interpreter
