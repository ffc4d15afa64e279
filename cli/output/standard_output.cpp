#include "cli/output/standard_output.h"

#include "renderer/image/image_file.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string_view>
#include <system_error>

namespace isl::cli {
namespace {

std::string failure(int error) {
  return fmt::format("cannot write to standard output: {}", std::generic_category().message(error));
}

/// During its lifetime, writing to a pipe without a reader is an error of the call and does not end the process.
class WithoutPipeSignal {
 public:
  WithoutPipeSignal() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &ignore, &before_);
  }
  ~WithoutPipeSignal() { sigaction(SIGPIPE, &before_, nullptr); }
  WithoutPipeSignal(const WithoutPipeSignal&) = delete;
  WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

 private:
  struct sigaction before_ {};
};

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

std::string write_standard_output(std::span<const unsigned char> bytes) {
  const WithoutPipeSignal guard;
  while (!bytes.empty()) {
    const ssize_t written = write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return failure(errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return "";
}

}  // namespace isl::cli
