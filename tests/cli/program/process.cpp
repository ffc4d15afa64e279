#include "tests/cli/program/process.h"

#include "base/check.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>

extern char** environ;

namespace isl::test {
namespace {

struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() { ISL_CHECK(pipe2(ends.data(), O_CLOEXEC) == 0); }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_end(int end) {
    if (ends[end] >= 0) close(ends[end]);
    ends[end] = -1;
  }
};

/// Opens a terminal in raw mode: end 0 reads the bytes written to end 1, unchanged.
void open_terminal(Pipe& pipe) {
  pipe.close_end(0);
  pipe.close_end(1);
  pipe.ends[0] = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  ISL_CHECK(pipe.ends[0] >= 0 && grantpt(pipe.ends[0]) == 0 && unlockpt(pipe.ends[0]) == 0);
  pipe.ends[1] = open(ptsname(pipe.ends[0]), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios settings{};
  ISL_CHECK(tcgetattr(pipe.ends[1], &settings) == 0);
  cfmakeraw(&settings);
  ISL_CHECK(tcsetattr(pipe.ends[1], TCSANOW, &settings) == 0);
}

/// Opens `out` as the kind of output asked for.
void prepare_output(Pipe& out, const ProcessOptions& options) {
  using Output = ProcessOptions::Output;
  if (options.output == Output::terminal) open_terminal(out);
  if (options.output == Output::file) {
    out.close_end(1);
    out.ends[1] = open(options.output_file.c_str(), O_WRONLY | O_CLOEXEC);
    ISL_CHECK(out.ends[1] >= 0, "{}", options.output_file.string());
  }
  if (options.output == Output::unread || options.output == Output::file) out.close_end(0);
}

/// Reads all available bytes; closes the pipe at the end of the file.
void drain(Pipe& pipe, std::string& text) {
  std::array<char, 65536> buffer{};
  const ssize_t count = ::read(pipe.ends[0], buffer.data(), buffer.size());
  if (count > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  } else {
    pipe.close_end(0);
  }
}

pid_t start(const std::vector<std::string>& command, const ProcessOptions& options, int in, int out, int err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in, 0);
  posix_spawn_file_actions_adddup2(&actions, out, 1);
  if (options.output == ProcessOptions::Output::closed) posix_spawn_file_actions_addclose(&actions, 1);
  posix_spawn_file_actions_adddup2(&actions, err, 2);
  if (!options.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str());
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  pid_t pid = -1;
  const int failed = posix_spawn(&pid, command.front().c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ISL_CHECK(failed == 0, "cannot start {}", command.front());
  return pid;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  using Clock = std::chrono::steady_clock;
  // Results of tests must not depend on the machine: POV-Ray's include files are found only if a test names folders.
  setenv("ISL_SYSTEM_LIBRARIES", "", 0);
  // Inputs of tests are smaller than a pipe's buffer, so that writing before reading cannot block.
  ISL_CHECK(options.input.size() <= 65536);
  Pipe in, out, err;
  prepare_output(out, options);
  if (options.err_terminal) open_terminal(err);
  ProcessResult result;
  const Clock::time_point begin = Clock::now();
  const pid_t pid = start(command, options, in.ends[0], out.ends[1], err.ends[1]);
  in.close_end(0);
  out.close_end(1);
  err.close_end(1);
  ISL_CHECK(write(in.ends[1], options.input.data(), options.input.size()) ==
            static_cast<ssize_t>(options.input.size()));
  in.close_end(1);

  bool marked = !options.when_marked;
  while (out.ends[0] >= 0 || err.ends[0] >= 0) {
    if (!marked && result.err.find(options.err_marker) != std::string::npos) {
      marked = true;
      options.when_marked(pid);
    }
    std::array<pollfd, 2> waiting{
        {{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}}};  // poll ignores a negative descriptor
    poll(waiting.data(), waiting.size(), 50);
    if (waiting[0].revents != 0) drain(out, result.out);
    if (waiting[1].revents != 0) drain(err, result.err);
    if (Clock::now() - begin > options.limit) kill(pid, SIGKILL);
  }
  int status = 0;
  rusage usage{};
  wait4(pid, &status, 0, &usage);
  result.peak_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
  result.seconds = Clock::now() - begin;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace isl::test
