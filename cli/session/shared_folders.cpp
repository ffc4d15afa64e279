#include "cli/session/shared_folders.h"

#include "base/files/descriptor.h"
#include "base/system_message.h"
#include "grammar/readable_folders.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace isl::cli {

namespace fs = std::filesystem;

namespace {

/// A link would let the mark of one folder stand in another.
bool is_marked(const fs::path& folder) {
  struct stat status {};
  return ::lstat((folder / grammar::kSharedFolderMark).c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

/// The folders of the list, as they were added: canonical.
std::vector<fs::path> listed() {
  std::vector<fs::path> folders;
  std::ifstream list(shared_folders_list());
  for (std::string line; std::getline(list, line);) folders.emplace_back(line);
  return folders;
}

/// Appends a line to the list. Returns what went wrong.
std::string append(const fs::path& folder) {
  const fs::path list = shared_folders_list();
  if (list.empty()) return "there is no home folder";
  std::error_code error;
  fs::create_directories(list.parent_path(), error);
  if (error) return error.message();
  const Descriptor file(
      ::open(list.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, S_IRUSR | S_IWUSR));
  const std::string line = folder.string() + '\n';
  // One call, so that lines of runs at the same time do not mix.
  if (!file.is_open() || ::write(file.get(), line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    return explain(errno);
  return {};
}

}  // namespace

fs::path shared_folders_list() {
  const char* const state = std::getenv("XDG_STATE_HOME");
  // The convention calls relative paths invalid.
  if (state != nullptr && *state == '/') return fs::path(state) / "isl/shared_folders";
  const fs::path home = grammar::home_folder();
  return home.empty() ? fs::path() : home / ".local/state/isl/shared_folders";
}

fs::path shared_folder_of(const fs::path& scene) {
  std::error_code error;
  const fs::path folder = scene.parent_path();
  fs::path above = fs::canonical(folder.empty() ? "." : folder, error);
  if (error) return {};
  const std::vector<fs::path> folders = listed();
  for (;; above = above.parent_path()) {
    const bool is_listed = std::ranges::find(folders, above) != folders.end();
    if (is_listed && is_marked(above) && grammar::may_be_project(above, grammar::home_folder())) return above;
    if (above == above.parent_path()) return {};
  }
}

std::vector<NewSharedFolder> remember_shared_folders(std::span<const fs::path> named) {
  std::vector<NewSharedFolder> added;
  for (const fs::path& name : named) {
    std::error_code error;
    const fs::path folder = fs::canonical(name, error);
    if (error || !is_marked(folder) || !grammar::may_be_project(folder, grammar::home_folder())) continue;
    if (folder.native().find('\n') != std::string::npos) continue;  // it would be two lines
    if (const auto known = listed(); std::ranges::find(known, folder) != known.end()) continue;
    added.push_back({folder, append(folder)});
  }
  return added;
}

}  // namespace isl::cli
