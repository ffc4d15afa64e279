// The program: parses the command line, then runs the command that it names.
#include "cli/commands/commands.h"
#include "cli/output/interrupt.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <variant>
#include <vector>

namespace isl::cli {
namespace {

ExitCode run(const Finished& finished) {
  std::fputs(finished.text.c_str(), finished.code == ExitCode::done ? stdout : stderr);
  return finished.code;
}

ExitCode run_any(const Command& command) {
  return std::visit([](const auto& chosen) { return run(chosen); }, command);
}

}  // namespace
}  // namespace isl::cli

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    isl::cli::catch_interrupts();
    // A limit on the size of files is handled like a full disk: the write fails, and its message names the file.
    std::signal(SIGXFSZ, SIG_IGN);
    return static_cast<int>(isl::cli::run_any(isl::cli::parse_command_line(arguments)));
  } catch (const std::bad_alloc&) {
    std::fputs("isl: error: the system has no memory left\n", stderr);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "isl: error: %s\n", failure.what());
  }
  return static_cast<int>(isl::cli::ExitCode::scene_error);
}
