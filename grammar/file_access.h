// The rules for the files that a scene may read and write, and the lookup from a name to a file. All reading of a scene
// (`#include`, `#fopen`, images) and all its writing go through this module; it knows nothing of the files' contents.
//
// Reading: the scene's folder, its working tree, the folders of the search path, those that the user allows besides,
// and all that lies below them (readable_folders.h). Writing: below the folders that the user allowed. A name is
// resolved (links, `..`, absolute paths) before it is judged, and the judged file is the opened one: the walk from the
// allowed folder follows no link. The text that a scene writes stays in memory, where the scene can read it again,
// until it has been read without errors; then it joins the run's other outputs (base/files/output_set.h).
#pragma once

#include "base/files/output_set.h"
#include "base/source_span.h"
#include "grammar/open_below.h"
#include "grammar/readable_folders.h"
#include "grammar/text_file.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isl::grammar {

enum class AccessError { none, not_found, refused };

/// The reason why there is no file; texts for the user.
struct AccessProblem {
  AccessError error = AccessError::none;
  std::string message;
  std::string hint;
};

/// A readable file, found but not read yet.
struct FoundFile {
  AccessProblem problem;            ///< `none` if the rest is valid
  std::filesystem::path shown;      ///< as the user would say it: relative if the folder was
  std::filesystem::path canonical;  ///< identifies the file
  FileStamp stamp;
  Descriptor folder;          ///< the folder that holds the file
  bool is_in_memory = false;  ///< written by this run
};

/// A place that may be written.
struct WritablePlace {
  AccessProblem problem;
  std::filesystem::path canonical;  ///< the name in the scene, if the file is kept in memory
  FileIdentity identity;
  Descriptor folder;  ///< the folder of the file; not open if the file is kept in memory
};

/// A written file that could not become one of the disk.
struct WriteFailure {
  std::string name;  ///< as the scene names it
  SourceSpan opened_at;
  std::string reason;
};

/// The folders that the user allows a scene, beside its own and its working tree.
struct AllowedFolders {
  std::vector<std::filesystem::path> search_path =
      {};                                         ///< searched after the asking file's and the scene's; read below
  std::vector<std::filesystem::path> read = {};   ///< files below them may be read; nothing is searched there
  std::vector<std::filesystem::path> write = {};  ///< files below them may be written
};

class FileAccess {
 public:
  /// `outputs`: those of the run, and its register of files.
  explicit FileAccess(AllowedFolders allowed, std::shared_ptr<OutputSet> outputs = std::make_shared<OutputSet>());

  /// Makes the scene's folder readable, and the base of relative names to write. For a scene that is a file there: it
  /// may read the working tree that it lies in.
  void set_scene_folder(const std::filesystem::path& folder);
  /// The same for a scene that is not a file: the folder's working tree says nothing about its origin.
  void set_current_folder(const std::filesystem::path& folder);
  /// Notes an input file: it may not be overwritten. The problem tells if it is an output of the run.
  /// `shown`: for the message.
  AccessProblem add_input(const FileIdentity& file, const std::filesystem::path& shown);

  /// Finds `name` among the files that this run wrote under that name, in the folder of the asking file, in the scene's
  /// folder, in the search path. If there is none, the problem names the file that may be meant.
  [[nodiscard]] FoundFile find(std::string_view name, const std::filesystem::path& asking_folder) const;
  [[nodiscard]] bool exists(std::string_view name, const std::filesystem::path& asking_folder) const;
  /// The file's text. `max_bytes` at most.
  [[nodiscard]] TextFile read(const FoundFile& file, std::size_t max_bytes) const;
  /// The file's content, which may be any bytes.
  [[nodiscard]] TextFile read_bytes(const FoundFile& file, std::size_t max_bytes) const;
  /// The file's name, the same on every machine: its path from the innermost folder that holds it, among the scene's
  /// and those of the search path; for a file elsewhere in the working tree, its path from the scene's. Empty for a
  /// file that this run wrote.
  [[nodiscard]] std::string portable_name(const FoundFile& file) const;

  /// The place for writing `name`: in the scene's folder if that is below an allowed one, else in an allowed one
  /// itself. It is never a link, an input, another output, or a file that is not regular. It is noted as an output.
  [[nodiscard]] WritablePlace find_writable(std::string_view name);
  /// A place in the memory of this run, for a user who allowed no writing and wants to go on.
  [[nodiscard]] WritablePlace in_memory(std::string_view name);
  /// The present content of the place, "" if there is no file.
  [[nodiscard]] TextFile read_existing(const WritablePlace& place, std::size_t max_bytes) const;
  /// Keeps `text` as the content of the place, and lets this run find it as `name`. `opened_at`: for stage_written().
  void write(const WritablePlace& place, std::string_view name, std::string text, SourceSpan opened_at);
  /// Makes complete files beside their places of all that was written; they take their places with the run's other
  /// outputs. Returns those that failed. Called once, when nothing will be read or written any more.
  [[nodiscard]] std::vector<WriteFailure> stage_written();
  /// Number of places found so far, each counted once.
  [[nodiscard]] std::size_t places_count() const { return places_.size(); }
  /// Bytes of all that was written.
  [[nodiscard]] std::size_t written_bytes() const { return written_bytes_; }
  [[nodiscard]] bool may_write() const { return !write_folders_.empty(); }

 private:
  struct WrittenFile {
    std::shared_ptr<const OutputFolder> folder;  ///< shared, since systems allow few open ones; null: kept in memory
    std::filesystem::path place;
    std::string name;  ///< the last one in the scene
    std::string text;
    FileStamp stamp;  ///< tells the versions of a file apart
    SourceSpan opened_at;
  };

  [[nodiscard]] ReadableFolders::Verdict verdict_on(const std::filesystem::path& canonical) const;
  [[nodiscard]] WritablePlace judge_place(const std::filesystem::path& candidate) const;
  [[nodiscard]] WritablePlace search_place(std::string_view name) const;
  [[nodiscard]] FoundFile judge(const std::filesystem::path& candidate) const;
  /// The file that this run wrote at a place.
  [[nodiscard]] static FoundFile as_found(const WrittenFile& file, std::filesystem::path shown);
  /// The folders to search for a name, in order, without duplicates.
  [[nodiscard]] std::vector<std::filesystem::path> folders_for(const std::filesystem::path& asking_folder) const;
  [[nodiscard]] FoundFile search(std::string_view name, const std::vector<std::filesystem::path>& folders) const;

  std::vector<std::filesystem::path> search_path_;
  std::optional<std::filesystem::path> scene_folder_;
  ReadableFolders readable_;
  std::vector<Folder> write_folders_;
  std::shared_ptr<OutputSet> outputs_;
  std::set<std::filesystem::path> places_;                           ///< noted as outputs
  std::map<std::filesystem::path, WrittenFile> written_;             ///< by the place
  std::map<std::string, std::filesystem::path, std::less<>> names_;  ///< by the name in the scene: its place
  std::size_t written_bytes_ = 0;
  std::uint64_t versions_ = 0;
};

/// A name for a message: only the beginning of a very long one.
[[nodiscard]] std::string shown_name(std::string_view name);

}  // namespace isl::grammar
