#include "base/files/refuge.h"

#include "base/files/staged_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>
#include <vector>

namespace isl {
namespace {

namespace fs = std::filesystem;

/// As many pictures of one name are kept in a folder; who has not looked by then does not want them.
constexpr int kMostOfOneName = 1000;

/// The folder that an environment variable names; "" unless it is an absolute path, which the rules of XDG demand.
fs::path folder_of(const char* variable) {
  const char* const value = std::getenv(variable);
  const fs::path folder = value == nullptr ? "" : value;
  return folder.is_absolute() ? folder : fs::path();
}

/// Exists while a file is written there; what was made for it is removed if it stays empty.
class Refuge {
 public:
  /// Makes the folders that are missing, for the user alone (XDG Base Directory Specification).
  explicit Refuge(fs::path folder) : folder_(std::move(folder)) {
    for (fs::path missing = folder_; !fs::exists(missing, ignored_) && missing.has_relative_path();
         missing = missing.parent_path()) {
      made_.push_back(missing);
    }
    for (auto path = made_.rbegin(); path != made_.rend(); ++path) ::mkdir(path->c_str(), 0700);
  }
  ~Refuge() {
    for (const fs::path& path : made_) ::rmdir(path.c_str());
  }
  Refuge(const Refuge&) = delete;
  Refuge& operator=(const Refuge&) = delete;

  [[nodiscard]] const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
  std::vector<fs::path> made_;  ///< the innermost first
  std::error_code ignored_;
};

std::vector<fs::path> places() {
  const fs::path home = folder_of("HOME"), cache = folder_of("XDG_CACHE_HOME"), temporary = folder_of("TMPDIR");
  std::vector<fs::path> result;
  if (!cache.empty() || !home.empty()) result.push_back((cache.empty() ? home / ".cache" : cache) / "isl");
  result.push_back(temporary.empty() ? fs::path("/tmp") : temporary);
  if (!home.empty()) result.push_back(home);
  return result;
}

/// A new file of that name or, if there is one, of the name with a number; not open if it cannot be made.
Descriptor create(const fs::path& folder, const fs::path& name, fs::path& file) {
  for (int number = 1; number <= kMostOfOneName; ++number) {
    file = folder / (number == 1 ? name.string()
                                 : fmt::format("{}-{}{}", name.stem().string(), number, name.extension().string()));
    Descriptor made(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
    if (made.is_open() || errno != EEXIST) return made;
  }
  return {};
}

}  // namespace

fs::path keep_elsewhere(const std::string& name, std::span<const unsigned char> bytes) {
  for (const fs::path& place : places()) {
    const Refuge refuge(place);
    fs::path file;
    const Descriptor made = create(refuge.folder(), name, file);
    if (!made.is_open()) continue;
    if (write_all(made.get(), bytes) && ::fsync(made.get()) == 0) return file;
    ::unlink(file.c_str());
  }
  return {};
}

}  // namespace isl
