#include "grammar/open_below.h"

#include "base/check.h"

#include <fcntl.h>

#include <algorithm>
#include <system_error>

namespace isl::grammar {

namespace fs = std::filesystem;

Folder::Folder(const fs::path& path) {
  std::error_code error;
  path_ = fs::canonical(path.empty() ? "." : path, error);
  if (!error) descriptor_ = Descriptor(::open(path_.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
}

bool Folder::holds(const fs::path& canonical) const {
  return std::mismatch(path_.begin(), path_.end(), canonical.begin(), canonical.end()).first == path_.end();
}

Descriptor Folder::open_folder(const fs::path& canonical) const {
  ISL_CHECK(holds(canonical), "{} below {}", canonical.string(), path_.string());
  constexpr int kFlags = O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
  Descriptor folder(::openat(descriptor_.get(), ".", kFlags));
  auto name = std::next(canonical.begin(), std::distance(path_.begin(), path_.end()));
  for (; folder.is_open() && name != canonical.end(); ++name) {
    folder = Descriptor(::openat(folder.get(), name->c_str(), kFlags));
  }
  return folder;
}

}  // namespace isl::grammar
