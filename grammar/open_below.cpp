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

fs::path Folder::below(const fs::path& canonical) const {
  ISL_CHECK(holds(canonical), "{} below {}", canonical.string(), path_.string());
  fs::path relative;
  auto name = std::next(canonical.begin(), std::distance(path_.begin(), path_.end()));
  for (; name != canonical.end(); ++name) relative /= *name;
  return relative;
}

Descriptor Folder::open_folder(const fs::path& canonical) const {
  constexpr int kFlags = O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
  Descriptor folder(::openat(descriptor_.get(), ".", kFlags));
  for (const fs::path& name : below(canonical)) {
    if (!folder.is_open()) break;
    folder = Descriptor(::openat(folder.get(), name.c_str(), kFlags));
  }
  return folder;
}

}  // namespace isl::grammar
