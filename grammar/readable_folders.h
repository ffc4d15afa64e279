// Which files a scene may read: those below its own folder, below the folders of the search path, and of the working
// tree of version control that it lies in. Judges paths without links; finding files by name is file_access.h's.
#pragma once

#include "grammar/open_below.h"

#include <filesystem>
#include <vector>

namespace isl::grammar {

/// A folder (canonical, as `home` is) may be the root of a working tree: it is not `/`, not the home folder or one that
/// holds it, and not one into which everybody may write (such as `/tmp`, where another user could plant a `.git`).
/// Those hold more than one project.
[[nodiscard]] bool may_be_project(const std::filesystem::path& folder, const std::filesystem::path& home);

/// The root of the working tree that holds `folder`: the nearest folder, from `folder` upwards, with a `.git`, `.hg` or
/// `.svn` in it. Empty where there is none, or where that folder may be no project.
[[nodiscard]] std::filesystem::path working_tree_of(const std::filesystem::path& folder);

/// A path below a folder leads into version control's own files: one of its names is `.git`, `.hg` or `.svn`, in
/// whatever case. They hold addresses and passwords of servers, and commands that other programs run.
[[nodiscard]] bool is_in_version_control(const std::filesystem::path& relative);

class ReadableFolders {
 public:
  /// Does nothing where `path` is no folder or closed to us.
  void add(const std::filesystem::path& path);

  struct Verdict {
    const Folder* folder = nullptr;      ///< the first that allows the file; null: it may not be read
    bool is_in_version_control = false;  ///< that is why
  };
  /// `canonical`: absolute, without links.
  [[nodiscard]] Verdict judge(const std::filesystem::path& canonical) const;

 private:
  std::vector<Folder> folders_;
};

}  // namespace isl::grammar
