#include "grammar/readable_folders.h"

#include <pwd.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace isl::grammar {
namespace {

namespace fs = std::filesystem;

constexpr std::array kVersionControlNames{".git", ".hg", ".svn"};

/// `.git` may be a file as well: in further working trees and submodules it names the folder.
bool is_marked(const fs::path& folder) {
  return std::ranges::any_of(kVersionControlNames, [&](const char* name) {
    struct stat status {};
    return ::lstat((folder / name).c_str(), &status) == 0;
  });
}

bool everybody_may_write(const fs::path& folder) {
  struct stat status {};
  return ::stat(folder.c_str(), &status) != 0 || (status.st_mode & S_IWOTH) != 0;
}

bool holds(const fs::path& folder, const fs::path& path) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

fs::path home_folder() {
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') {
    const passwd* const entry = ::getpwuid(::getuid());
    home = entry == nullptr ? "" : entry->pw_dir;
  }
  std::error_code error;
  fs::path canonical = fs::canonical(home, error);
  return error ? fs::path() : canonical;
}

bool may_be_project(const fs::path& folder, const fs::path& home) {
  return folder != folder.root_path() && !holds(folder, home) && !everybody_may_write(folder);
}

fs::path working_tree_of(const fs::path& folder) {
  std::error_code error;
  fs::path root = fs::canonical(folder.empty() ? "." : folder, error);
  if (error) return {};
  while (!is_marked(root)) {
    if (root == root.parent_path()) return {};
    root = root.parent_path();
  }
  return may_be_project(root, home_folder()) ? root : fs::path();
}

bool is_in_version_control(const fs::path& relative) {
  return std::ranges::any_of(relative, [](const fs::path& part) {
    return std::ranges::any_of(kVersionControlNames,
                               [&](const char* name) { return ::strcasecmp(part.c_str(), name) == 0; });
  });
}

bool is_shared_mark(const fs::path& name) { return ::strcasecmp(name.c_str(), kSharedFolderMark) == 0; }

void ReadableFolders::add(const fs::path& path) {
  if (Folder folder(path); folder.is_open()) folders_.push_back(std::move(folder));
}

ReadableFolders::Verdict ReadableFolders::judge(const fs::path& canonical) const {
  Verdict verdict;
  for (const Folder& folder : folders_) {
    if (!folder.holds(canonical)) continue;
    // The user may name a folder within `.git`; the scene may then read it.
    if (!is_in_version_control(folder.below(canonical))) return {&folder, false};
    verdict.is_in_version_control = true;
  }
  return verdict;
}

}  // namespace isl::grammar
