// Conditions, loops and #switch: they choose the frame that runs next. They evaluate only their own conditions.
#pragma once

#include "interpreter/arithmetic.h"
#include "interpreter/context.h"

namespace isl::interpreter {

/// Starts an #if, #ifdef, #while, #for or #switch: pushes the frame that it leads to, or none.
void start_control(Context& context, const grammar::Node& node);

/// Called at the end of a frame's items: true if it goes on (a loop's next turn, the next case of a #switch).
[[nodiscard]] bool continue_frame(Context& context, Frame& frame);

/// Sets the variable of a #for to its start; true if it makes a turn. Fails if the step is zero.
[[nodiscard]] bool begin_for(Context& context, const grammar::For& node, double start, const Frame::Range& range);
/// True if a #for whose variable has the value `value` makes another turn. The tolerance is POV-Ray's: 0 to 1 by 0.1 is
/// eleven turns.
[[nodiscard]] inline bool has_turn(double value, double end, double step) {
  return step > 0 ? value < end + kTolerance : value > end - kTolerance;
}
/// Adds the step to the variable; true if another turn follows.
[[nodiscard]] bool next_for(Context& context, const grammar::For& node, const Frame::Range& range);
/// True if a name or element has a value, for #ifdef.
[[nodiscard]] bool is_declared(Context& context, const grammar::Node& target);

/// After an error in a block whose end is no part of it (grammar::BlockBegin): skips its items as far as they can be
/// told, up to its end, or a directive that may hold that.
void skip_abandoned(Context& context);

/// `#break`: leaves the innermost loop or #switch, or returns from a macro; `base` is the bottom frame of the stream
/// that met it.
void break_out(Context& context, std::size_t base, const grammar::Node& node);

}  // namespace isl::interpreter
