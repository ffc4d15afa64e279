// Where a scene may read and write files, and how a name in it becomes a file. The one place that all of its reading
// (`#include`, `#fopen`, images) and writing goes through; knows nothing of what stands in the files.
//
// Reading: the scene's folder, its working tree, the folders of the search path, and what is below them
// (readable_folders.h). Writing: below the folders that the user allowed. A name is resolved (links, `..`, absolute
// paths) before it is judged, and what is opened is what was judged: the walk from the allowed folder follows no link.
#pragma once

#include "grammar/open_below.h"
#include "grammar/readable_folders.h"
#include "grammar/text_file.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isl::grammar {

enum class AccessError { none, not_found, refused };

/// Why there is no file; texts for the user.
struct AccessProblem {
  AccessError error = AccessError::none;
  std::string message;
  std::string hint;
};

/// A file that may be read, found but not read yet.
struct FoundFile {
  AccessProblem problem;            ///< `none` where the rest holds
  std::filesystem::path shown;      ///< as the user would say it, relative where the folder was
  std::filesystem::path canonical;  ///< what it is known by
  FileStamp stamp;
  Descriptor folder;          ///< where it stands
  bool is_in_memory = false;  ///< written by this run, and never to a disk
};

/// A place that may be written.
struct WritablePlace {
  AccessProblem problem;
  std::filesystem::path canonical;
  Descriptor folder;  ///< where it stands; not open: it is kept in memory
};

class FileAccess {
 public:
  /// `search_path`: where names are looked for after the folder of the file that asks and the scene's. `write_folders`:
  /// below these files may be written.
  FileAccess(std::vector<std::filesystem::path> search_path, const std::vector<std::filesystem::path>& write_folders);

  /// The scene's folder is readable too, and where relative names to write start from. The scene is a file there: it
  /// may read the working tree that it lies in.
  void set_scene_folder(const std::filesystem::path& folder);
  /// The same for a scene that is no file: the folder's working tree says nothing about where it comes from.
  void set_current_folder(const std::filesystem::path& folder);
  /// A file that was read: it may not be written over.
  void add_input(const FileStamp& stamp);

  /// `name` in what this run wrote under that name, in the folder of the file that asks, in the scene's folder, in the
  /// search path. Where there is none, the problem names the file that may be meant.
  [[nodiscard]] FoundFile find(std::string_view name, const std::filesystem::path& asking_folder) const;
  [[nodiscard]] bool exists(std::string_view name, const std::filesystem::path& asking_folder) const;
  /// Its text. `max_bytes` at most.
  [[nodiscard]] TextFile read(const FoundFile& file, std::size_t max_bytes) const;
  /// Its content, which may be any bytes.
  [[nodiscard]] TextFile read_bytes(const FoundFile& file, std::size_t max_bytes) const;
  /// What a file is called on every machine: its path from the innermost folder that holds it, of the scene's and those
  /// of the search path; of a file elsewhere in the working tree, from the scene's. Empty for what this run wrote.
  [[nodiscard]] std::string portable_name(const FoundFile& file) const;

  /// Where `name` may be written: in the scene's folder if that is below an allowed one, else in an allowed one itself.
  /// Never a link, an input, or what is no regular file.
  [[nodiscard]] WritablePlace find_writable(std::string_view name) const;
  /// A place in the memory of this run, for a user who allowed no writing and wants to go on.
  [[nodiscard]] static WritablePlace in_memory(std::string_view name);
  /// What stands at the place already, "" where nothing does.
  [[nodiscard]] TextFile read_existing(const WritablePlace& place, std::size_t max_bytes) const;
  /// Makes `text` the content of the place, wholly or not at all, and lets this run find it as `name`. Returns what
  /// went wrong, or "".
  [[nodiscard]] std::string write(const WritablePlace& place, std::string_view name, std::string text);
  [[nodiscard]] bool may_write() const { return !write_folders_.empty(); }

 private:
  struct MemoryFile {
    std::string text;
    FileStamp stamp;
  };

  [[nodiscard]] ReadableFolders::Verdict verdict_on(const std::filesystem::path& canonical) const;
  [[nodiscard]] WritablePlace judge_place(const std::filesystem::path& candidate) const;
  [[nodiscard]] FoundFile judge(const std::filesystem::path& candidate) const;
  /// The folders where a name is looked for, in order, each once.
  [[nodiscard]] std::vector<std::filesystem::path> folders_for(const std::filesystem::path& asking_folder) const;
  [[nodiscard]] FoundFile search(std::string_view name, const std::vector<std::filesystem::path>& folders) const;

  std::vector<std::filesystem::path> search_path_;
  std::optional<std::filesystem::path> scene_folder_;
  ReadableFolders readable_;
  std::vector<Folder> write_folders_;
  std::set<std::pair<std::uint64_t, std::uint64_t>> inputs_;           ///< device and inode
  std::map<std::string, std::filesystem::path, std::less<>> written_;  ///< by the name in the scene: its canonical path
  std::set<std::filesystem::path> written_paths_;
  std::map<std::string, MemoryFile, std::less<>> memory_;  ///< by the name in the scene
  std::uint64_t memory_count_ = 0;
};

/// A name for a message: its beginning, where it is longer than anyone would read.
[[nodiscard]] std::string shown_name(std::string_view name);

}  // namespace isl::grammar
