// The end of a directive's statement: its semicolon or, after a mistake, the last item before the next statement.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// Skips the directive's own semicolon, which is the next item of the list that holds it; false if there is none.
inline bool skip_semicolon(Context& context) {
  Frame& frame = context.frames.back();
  if (frame.next == frame.end || (*frame.next)->kind != grammar::NodeKind::semicolon) return false;
  ++frame.next;
  return true;
}

/// Called after a mistake: the rest of the statement, such as the braces in `= mistake { … };`, must not cause a second
/// error. If another statement begins before a semicolon, the first one has none, and nothing is skipped.
void skip_rest(Context& context);

}  // namespace isl::interpreter
