// Runs a program as a user would and tells what it did. For tests only.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace isl::test {

struct ProcessResult {
  int exit_code = -1;  ///< 128 + signal where a signal ended it
  std::string out;     ///< of a terminal too
  std::string err;
  std::chrono::duration<double> seconds{0};
};

struct ProcessOptions {
  std::filesystem::path folder{};  ///< working directory; empty: the caller's
  std::string input{};             ///< standard input; empty: end of file at once
  /// Called when it has written `err_marker` to standard error ("": at once after its start), with its process id.
  std::function<void(int)> when_marked{};
  std::string err_marker{};
  std::chrono::seconds limit{120};  ///< then it is killed
  /// Where its standard output goes instead of into the result. unread: a pipe whose reader is gone; closed: nowhere.
  enum class Output { captured, terminal, unread, closed, file } output = Output::captured;
  std::filesystem::path output_file{};  ///< for `file`: exists already
  bool err_terminal = false;            ///< its standard error is a terminal; `err` is what that was sent
};

/// `command[0]` is a path. Never goes through a shell.
[[nodiscard]] ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options = {});

}  // namespace isl::test
