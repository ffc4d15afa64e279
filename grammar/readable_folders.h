// The files that a scene may read: those below its own folder, below the folders of the search path, and below the
// working tree of version control that it lies in. Judges paths without links; file_access.h finds files by name.
#pragma once

#include "grammar/open_below.h"

#include <filesystem>
#include <vector>

namespace isl::grammar {

/// The user's home folder, canonical; empty if there is none.
[[nodiscard]] std::filesystem::path home_folder();

/// True if a folder (canonical, as `home` is) may be the root of a working tree: it is not `/`, not the home folder or
/// a parent of it, and not writable by every user (such as `/tmp`, where another user could plant a `.git`). Those
/// folders hold more than one project.
[[nodiscard]] bool may_be_project(const std::filesystem::path& folder, const std::filesystem::path& home);

/// The root of the working tree that holds `folder`: the nearest folder, from `folder` upwards, with a `.git`, `.hg` or
/// `.svn` in it. Empty if there is none, or if that folder cannot be a project.
[[nodiscard]] std::filesystem::path working_tree_of(const std::filesystem::path& folder);

/// True if a path below a folder leads into version control's own files: one of its names is `.git`, `.hg` or `.svn`,
/// in any case of letters. Those hold addresses and passwords of servers, and commands that other programs run.
[[nodiscard]] bool is_in_version_control(const std::filesystem::path& relative);

/// The name of the file that marks a folder whose files many scenes share (cli/session/shared_folders.h). Its content
/// has no meaning.
inline constexpr const char* kSharedFolderMark = "isl.ini";

/// True for the name of that file, in any case of letters.
[[nodiscard]] bool is_shared_mark(const std::filesystem::path& name);

class ReadableFolders {
 public:
  /// Does nothing if `path` is not a folder or is not accessible.
  void add(const std::filesystem::path& path);

  struct Verdict {
    const Folder* folder = nullptr;      ///< the first that allows the file; null: it may not be read
    bool is_in_version_control = false;  ///< the reason of a refusal
  };
  /// `canonical`: absolute, without links.
  [[nodiscard]] Verdict judge(const std::filesystem::path& canonical) const;

 private:
  std::vector<Folder> folders_;
};

}  // namespace isl::grammar
