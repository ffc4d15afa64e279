// The program: parses the command line, then runs the command that it names.
#include "cli/commands/commands.h"
#include "cli/output/console.h"
#include "cli/output/run_end.h"
#include "cli/output/standard_output.h"

#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <variant>
#include <vector>

namespace isl::cli {
namespace {

ExitCode run(const Finished& finished) {
  print(finished.code == ExitCode::done ? Stream::output : Stream::error, finished.text);
  return finished.code;
}

ExitCode run_any(const Command& command) {
  return std::visit([](const auto& chosen) { return run(chosen); }, command);
}

/// Results that did not arrive are as bad as files that could not be written. Other errors were told before.
ExitCode finish_output(ExitCode code) {
  const std::string problem = finish_standard_output();
  if (problem.empty()) return code;
  print(Stream::error, "isl: error: " + problem + "\n");
  return code == ExitCode::done ? ExitCode::file_error : code;
}

}  // namespace
}  // namespace isl::cli

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    isl::cli::prepare_standard_streams();
    isl::cli::catch_signals();
    // A limit on the size of files is handled like a full disk: the write fails, and its message names the file.
    std::signal(SIGXFSZ, SIG_IGN);
    const isl::cli::ExitCode code = isl::cli::run_any(isl::cli::parse_command_line(arguments));
    return static_cast<int>(isl::cli::finish_output(code));
  } catch (const std::bad_alloc&) {
    isl::cli::print(isl::cli::Stream::error, "isl: error: the system has no memory left\n");
  } catch (const std::exception& failure) {
    isl::cli::print(isl::cli::Stream::error, std::string("isl: error: ") + failure.what() + "\n");
  }
  return static_cast<int>(isl::cli::ExitCode::scene_error);
}
