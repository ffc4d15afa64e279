// Folders of many scenes that share files: with an `isl.ini` in it, a folder that the user names once is readable from
// then on for every scene below it, as if --allow-read named it.
//
// The file alone allows nothing, because it may have come with the scene: the user's own list, outside the scene's
// reach, must hold the folder. The list grows only by folders of the command line, not by those of an .ini file. So no
// scene, and nothing that lies beside it, widens what it may read.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace isl::cli {

/// The user's list of folders, one a line: `isl/shared_folders` in the environment variable XDG_STATE_HOME or, if that
/// is not set, in ~/.local/state. Empty without a home folder.
[[nodiscard]] std::filesystem::path shared_folders_list();

/// The innermost shared folder in the list that holds the scene, a file; empty if there is none.
[[nodiscard]] std::filesystem::path shared_folder_of(const std::filesystem::path& scene);

struct NewSharedFolder {
  std::filesystem::path folder;
  std::string trouble;  ///< why it could not be added; empty if it was
};

/// Adds to the list those of the folders that hold the mark and are not in it. Left out are the folders that cannot be
/// a project (grammar/readable_folders.h).
[[nodiscard]] std::vector<NewSharedFolder> remember_shared_folders(std::span<const std::filesystem::path> named);

}  // namespace isl::cli
