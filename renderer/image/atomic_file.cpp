#include "renderer/image/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace isl::render {
namespace {

namespace fs = std::filesystem;

std::string failure(const char* doing, const fs::path& path, int error) {
  return fmt::format("cannot {} {}: {}", doing, path.string(), std::generic_category().message(error));
}

/// The file that a path names in the end: renaming over a link would replace the link.
fs::path resolved(const fs::path& path) {
  std::error_code problem;
  if (!fs::is_symlink(path, problem)) return path;
  const fs::path target = fs::weakly_canonical(path, problem);
  return problem ? path : target;
}

/// A name beside `target` that no other process and no other call uses.
fs::path temporary_beside(const fs::path& target) {
  static std::atomic<unsigned> counter = 0;
  fs::path temporary = target;
  temporary.replace_filename(fmt::format(".{}.{}-{}.tmp", target.filename().string(), getpid(), counter++));
  return temporary;
}

/// An open file that is gone again unless it was kept.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path)
      : path_(std::move(path)), descriptor_(open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {}
  ~TemporaryFile() {
    if (descriptor_ < 0) return;
    close(descriptor_);
    if (!kept_) unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }

  [[nodiscard]] bool write_all(std::span<const unsigned char> bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return fsync(descriptor_) == 0;
  }

  [[nodiscard]] bool rename_to(const fs::path& target) {
    kept_ = rename(path_.c_str(), target.c_str()) == 0;
    return kept_;
  }

  /// Takes over the permissions of the file that it will replace.
  void copy_mode(const fs::path& target) const {
    struct stat status {};
    if (stat(target.c_str(), &status) == 0) static_cast<void>(fchmod(descriptor_, status.st_mode & 07777));
  }

 private:
  fs::path path_;
  int descriptor_;
  bool kept_ = false;
};

/// Makes the renaming itself survive a power cut. File systems that cannot do this are left alone.
void flush_folder(const fs::path& folder) {
  const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  static_cast<void>(fsync(descriptor));
  close(descriptor);
}

std::string why_not_replaceable(const fs::path& target) {
  struct stat status {};
  if (stat(target.c_str(), &status) != 0) return errno == ENOENT ? "" : failure("write", target, errno);
  if (S_ISDIR(status.st_mode)) return fmt::format("cannot write {}: it is a folder", target.string());
  if (!S_ISREG(status.st_mode)) return fmt::format("cannot write {}: it is not an ordinary file", target.string());
  if (access(target.c_str(), W_OK) != 0) return failure("write", target, errno);
  return "";
}

}  // namespace

std::string why_not_writable(const std::string& path) {
  const fs::path target = resolved(path);
  if (std::string reason = why_not_replaceable(target); !reason.empty()) return reason;
  const TemporaryFile probe(temporary_beside(target));
  return probe.is_open() ? "" : failure("write", target, errno);
}

std::string write_atomically(const std::string& path, std::span<const unsigned char> bytes) {
  const fs::path target = resolved(path);
  if (std::string reason = why_not_replaceable(target); !reason.empty()) return reason;
  TemporaryFile file(temporary_beside(target));
  if (!file.is_open()) return failure("write", target, errno);
  file.copy_mode(target);
  if (!file.write_all(bytes)) return failure("write", target, errno);
  if (!file.rename_to(target)) return failure("replace", target, errno);
  flush_folder(target.parent_path());
  return "";
}

}  // namespace isl::render
