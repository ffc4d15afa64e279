#include "grammar/replace_file.h"

#include "grammar/descriptor.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace isl::grammar {
namespace {

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

std::string replace_file(int folder, const std::string& name, std::string_view bytes) {
  static unsigned counter = 0;
  const std::string temporary = fmt::format(".isl-{}-{}.tmp", ::getpid(), counter++);
  const Descriptor file(
      ::openat(folder, temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (!file.is_open()) return std::generic_category().message(errno);
  struct stat status {};
  if (::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(status.st_mode)) {
    static_cast<void>(::fchmod(file.get(), status.st_mode & 0777));
  }
  if (write_all(file.get(), bytes) && ::renameat(folder, temporary.c_str(), folder, name.c_str()) == 0) return "";
  const int code = errno;
  ::unlinkat(folder, temporary.c_str(), 0);
  return std::generic_category().message(code);
}

}  // namespace isl::grammar
