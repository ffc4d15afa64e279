// Runs a program as a user would and reports what it did. For tests only.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace isl::test {

struct ProcessResult {
  int exit_code = -1;  ///< 128 + signal if a signal ended it
  std::string out;     ///< also what a terminal received
  std::string err;
  std::chrono::duration<double> seconds{0};
  std::size_t peak_bytes = 0;  ///< the most memory that it had at a time
};

struct ProcessOptions {
  std::filesystem::path folder{};  ///< working directory; empty: the caller's
  std::string input{};             ///< standard input; empty: end of file at once
  /// Called with its process id when it has written `err_marker` to standard error ("": right after its start).
  std::function<void(int)> when_marked{};
  std::string err_marker{};
  std::chrono::seconds limit{120};  ///< after this time it is killed
  /// The destination of its standard output. unread: a pipe whose reader is gone; closed: none.
  enum class Output { captured, terminal, unread, closed, file } output = Output::captured;
  std::filesystem::path output_file{};  ///< for `file`: an existing file
  bool err_terminal = false;            ///< its standard error is a terminal; `err` is what the terminal received
};

/// `command[0]` is a path. Never goes through a shell.
[[nodiscard]] ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options = {});

}  // namespace isl::test
