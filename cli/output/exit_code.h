// The exit status of the process. A contract: scripts rely on these numbers.
#pragma once

namespace isl::cli {

enum class ExitCode : int {
  done = 0,
  scene_error = 1,         ///< the scene has errors
  command_line_error = 2,  ///< the command line has errors
  file_error = 3,          ///< a file could not be read or written
  ended = 75,         ///< ended by SIGTERM, SIGHUP or --max-time; queues read it as "again" (EX_TEMPFAIL of sysexits.h)
  interrupted = 130,  ///< Ctrl-C, as shells report it
};

}  // namespace isl::cli
