#include "cli/output/standard_output.h"

#include "base/system_message.h"
#include "renderer/image/image_file.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string_view>

namespace isl::cli {
namespace {

std::string failure(int error) { return fmt::format("cannot write to standard output: {}", explain(error)); }

/// Writes all bytes and returns 0, or the error. Waits for a slow reader of a pipe that another process made
/// non-blocking.
int write_stream(int stream, std::span<const unsigned char> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(stream, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {
      pollfd waiting{stream, POLLOUT, 0};
      ::poll(&waiting, 1, -1);
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

}  // namespace

std::string standard_output_format(const std::filesystem::path& output) {
  const std::string name = output.string();
  const std::string_view format(name.data(), name.ends_with(":-") ? name.size() - 2 : 0);
  return render::image_format_of(fmt::format(".{}", format));
}

bool standard_output_is_terminal() { return isatty(STDOUT_FILENO) != 0; }

std::string why_no_standard_output() {
  const int flags = fcntl(STDOUT_FILENO, F_GETFL);
  if (flags < 0) return failure(errno);
  if ((flags & O_ACCMODE) == O_RDONLY) return failure(EBADF);
  return "";
}

void prepare_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // The lowest free number is that of the closed stream. Its mode makes reading or writing an error, as before.
    if (fcntl(stream, F_GETFD) < 0) static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
  std::signal(SIGPIPE, SIG_IGN);
}

std::string write_standard_output(std::span<const unsigned char> bytes) {
  const int error = write_stream(STDOUT_FILENO, bytes);
  return error == 0 ? "" : failure(error);
}

void write_standard_error(std::span<const unsigned char> bytes) {
  static_cast<void>(write_stream(STDERR_FILENO, bytes));
}

}  // namespace isl::cli
