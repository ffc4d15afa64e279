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
#include <utility>

namespace isl::render {
namespace {

namespace fs = std::filesystem;

std::string failure(const char* doing, const fs::path& path, int error) {
  return fmt::format("cannot {} {}: {}", doing, path.string(), std::generic_category().message(error));
}

/// The file that a path finally names. Renaming over a link would replace the link.
fs::path resolved(const fs::path& path) {
  std::error_code problem;
  if (!fs::is_symlink(path, problem)) return path;
  const fs::path target = fs::weakly_canonical(path, problem);
  return problem ? path : target;
}

/// A name in the folder of `target` that no other process and no other call uses.
fs::path temporary_beside(const fs::path& target) {
  static std::atomic<unsigned> counter = 0;
  fs::path temporary = target;
  temporary.replace_filename(fmt::format(".{}.{}-{}.tmp", target.filename().string(), getpid(), counter++));
  return temporary;
}

int open_new(const fs::path& path) { return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666); }

/// Gives the file the permissions of the one that it will replace.
void copy_mode(int descriptor, const fs::path& target) {
  struct stat status {};
  if (stat(target.c_str(), &status) == 0) static_cast<void>(fchmod(descriptor, status.st_mode & 07777));
}

/// Makes the renaming itself survive a power cut. File systems that cannot do this are ignored.
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
  const fs::path probe = temporary_beside(target);
  const int descriptor = open_new(probe);
  if (descriptor < 0) return failure("write", target, errno);
  close(descriptor);
  unlink(probe.c_str());
  return "";
}

StagedFile::StagedFile(const std::string& path, std::span<const unsigned char> bytes)
    : target_(resolved(path)), temporary_(temporary_beside(target_)), error_(why_not_replaceable(target_)) {
  if (!error_.empty()) return;
  descriptor_ = open_new(temporary_);
  if (descriptor_ >= 0) copy_mode(descriptor_, target_);
  if (descriptor_ < 0 || !write_all(bytes)) error_ = failure("write", target_, errno);
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : target_(std::move(other.target_)),
      temporary_(std::move(other.temporary_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      error_(std::move(other.error_)) {}

StagedFile::~StagedFile() {
  if (descriptor_ < 0) return;
  close(descriptor_);
  unlink(temporary_.c_str());
}

bool StagedFile::write_all(std::span<const unsigned char> bytes) const {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return fsync(descriptor_) == 0;
}

std::string StagedFile::take_place() {
  if (rename(temporary_.c_str(), target_.c_str()) != 0) return failure("replace", target_, errno);
  close(std::exchange(descriptor_, -1));
  flush_folder(target_.parent_path());
  return "";
}

std::string write_atomically(const std::string& path, std::span<const unsigned char> bytes) {
  StagedFile file(path, bytes);
  return file.error().empty() ? file.take_place() : file.error();
}

}  // namespace isl::render
