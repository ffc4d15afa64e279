// The ways in which a run is ended from outside: Ctrl-C, a signal of the system or a queue, and --max-time. All of them
// set a flag that long work looks at, so that a picture's finished part is written. A second Ctrl-C ends the process at
// once.
#pragma once

#include "base/stop_flag.h"
#include "cli/output/exit_code.h"

#include <string_view>

namespace isl::cli {

/// After this call SIGINT, SIGTERM and SIGHUP set the flag instead of ending the process. A signal that was ignored
/// when the program started, as `nohup` does with SIGHUP, stays ignored.
void catch_signals();

/// Sets the flag after these seconds; 0 is at once.
void end_after(double seconds);

/// Lives as long as the process.
[[nodiscard]] const StopFlag& stop_flag();

/// The exit code of a run that was ended for this reason, which is not `none`.
[[nodiscard]] ExitCode exit_code_of(StopReason reason);

/// "interrupted" and the like, for messages.
[[nodiscard]] std::string_view text_of(StopReason reason);

}  // namespace isl::cli
