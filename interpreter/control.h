// Conditions, loops and #switch: which frame runs next. No evaluation of anything but their own conditions happens
// here.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// Starts an #if, #ifdef, #while, #for, #switch or an IfBlock: pushes the frame that it leads to, or none.
void start_control(Context& context, const grammar::Node& node);

/// At the end of a frame's items: true if it goes on (a loop's next turn, the next case of a #switch).
[[nodiscard]] bool continue_frame(Context& context, Frame& frame);

/// `#break`: leaves the innermost loop or #switch, or returns from a macro; `base` is the bottom frame of the stream
/// that met it.
void break_out(Context& context, std::size_t base, const grammar::Node& node);

}  // namespace isl::interpreter
