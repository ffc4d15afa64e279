#include "base/files/staged_file.h"

#include "base/files/temporary_file.h"
#include "base/system_message.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <utility>

namespace isl {
namespace {

namespace fs = std::filesystem;

/// A name that no other process and no other call uses.
std::string new_temporary_name() {
  static std::atomic<unsigned> counter = 0;
  return temporary_name(this_process(), counter++);
}

Descriptor open_new(int folder, const std::string& name) {
  return Descriptor(::openat(folder, name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
}

/// The reason why what stands at `name` cannot be replaced, or "". A link is replaced itself.
std::string why_not_replaceable(int folder, const std::string& name) {
  struct stat status {};
  if (::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) return errno == ENOENT ? "" : explain(errno);
  if (S_ISLNK(status.st_mode)) return "";
  if (S_ISDIR(status.st_mode)) return "it is a folder";
  if (!S_ISREG(status.st_mode)) return "it is not an ordinary file";
  return ::faccessat(folder, name.c_str(), W_OK, 0) == 0 ? "" : explain(errno);
}

/// Gives the file the permissions of the one that it will replace.
void copy_mode(int descriptor, int folder, const std::string& name) {
  struct stat status {};
  if (::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(status.st_mode)) return;
  static_cast<void>(::fchmod(descriptor, status.st_mode & 0777));
}

/// A folder that may be written but not listed can still take files; it cannot be synced.
Descriptor open_folder(int base, const char* path) {
  Descriptor folder(::openat(base, path, O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.is_open() && errno == EACCES) folder = Descriptor(::openat(base, path, O_PATH | O_DIRECTORY | O_CLOEXEC));
  return folder;
}

}  // namespace

bool write_all(int descriptor, std::span<const unsigned char> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

// ---- The folder -----------------------------------------------------------------------------------------------------

OutputFolder::OutputFolder(const fs::path& path)
    : path_(path), descriptor_(open_folder(AT_FDCWD, path.empty() ? "." : path.c_str())) {
  if (!is_open()) error_ = errno;
}

OutputFolder::OutputFolder(const Descriptor& folder, fs::path path)
    : path_(std::move(path)), descriptor_(open_folder(folder.get(), ".")) {
  if (!is_open()) error_ = errno;
}

std::string OutputFolder::why_not_writable(const std::string& name) const {
  if (!is_open()) return explain(error_);
  if (std::string reason = why_not_replaceable(get(), name); !reason.empty()) return reason;
  const std::string probe = new_temporary_name();
  if (!open_new(get(), probe).is_open()) return explain(errno);
  ::unlinkat(get(), probe.c_str(), 0);
  return "";
}

void OutputFolder::sync() const { static_cast<void>(::fsync(get())); }

bool OutputFolder::sync_file_system() const { return ::syncfs(get()) == 0; }

// ---- The file -------------------------------------------------------------------------------------------------------

StagedFile::StagedFile(std::shared_ptr<const OutputFolder> folder, std::string name,
                       std::span<const unsigned char> bytes, Sync when)
    : folder_(std::move(folder)), name_(std::move(name)) {
  error_ = folder_->is_open() ? why_not_replaceable(folder_->get(), name_) : explain(folder_->error());
  if (!error_.empty()) return;
  std::string temporary = new_temporary_name();
  const Descriptor file = open_new(folder_->get(), temporary);
  if (!file.is_open()) {
    error_ = explain(errno);
    return;
  }
  temporary_ = std::move(temporary);
  copy_mode(file.get(), folder_->get(), name_);
  const bool is_done = write_all(file.get(), bytes) && (when == Sync::later || ::fsync(file.get()) == 0);
  if (!is_done) error_ = explain(errno);
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : folder_(std::move(other.folder_)),
      name_(std::move(other.name_)),
      temporary_(std::exchange(other.temporary_, {})),
      error_(std::move(other.error_)) {}

StagedFile::~StagedFile() {
  if (!temporary_.empty()) ::unlinkat(folder_->get(), temporary_.c_str(), 0);
}

std::string StagedFile::sync() const {
  const Descriptor file(::openat(folder_->get(), temporary_.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC));
  return file.is_open() && ::fsync(file.get()) == 0 ? "" : explain(errno);
}

std::string StagedFile::take_place() {
  const int folder = folder_->get();
  if (::renameat(folder, temporary_.c_str(), folder, name_.c_str()) != 0) return explain(errno);
  temporary_.clear();
  return "";
}

std::vector<unsigned char> StagedFile::content() const {
  std::vector<unsigned char> bytes;
  const Descriptor file(::openat(folder_->get(), temporary_.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
  std::array<unsigned char, 65536> buffer{};
  while (file.is_open()) {
    const ssize_t count = ::read(file.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + count);
  }
  return bytes;
}

}  // namespace isl
