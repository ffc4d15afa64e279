#include "base/files/file_identity.h"

#include <sys/stat.h>

#include <system_error>

namespace isl {
namespace {

namespace fs = std::filesystem;

/// Linux follows this many links before it takes them for a circle.
constexpr int kMaxLinks = 40;

}  // namespace

fs::path canonical_path(const fs::path& file) {
  std::error_code error;
  fs::path path = fs::absolute(file, error);
  for (int links = 0; links < kMaxLinks && !error; ++links) {
    const fs::path name = path.filename();
    if (name.empty() || name == "." || name == "..") return fs::weakly_canonical(path, error);
    const fs::path folder = fs::weakly_canonical(path.parent_path(), error);
    if (error) break;
    path = folder / name;
    std::error_code is_no_link;
    const fs::path target = fs::read_symlink(path, is_no_link);
    if (is_no_link) return path;
    path = folder / target;  // an absolute target replaces the folder
  }
  return file.lexically_normal();
}

FileIdentity identity_of(const fs::path& file) {
  FileIdentity identity{canonical_path(file)};
  struct stat status {};
  if (::stat(identity.path.c_str(), &status) == 0) {
    identity.device = status.st_dev;
    identity.inode = status.st_ino;
  }
  return identity;
}

std::optional<FileIdentity> identity_of_stream(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileIdentity{{}, status.st_dev, status.st_ino};
}

}  // namespace isl
