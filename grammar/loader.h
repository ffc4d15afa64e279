// Text files → syntax trees: finds a file, reads it, runs the parser, and remembers the result. What the evaluator asks
// at each `#include` and cli asks once for the scene. Knows where files may be read from, and nothing of what they
// mean.
#pragma once

#include "base/diagnostic.h"
#include "grammar/arena.h"
#include "grammar/ast.h"
#include "grammar/complaint.h"
#include "grammar/data_file.h"
#include "grammar/file_access.h"
#include "grammar/library_index.h"
#include "grammar/source_map.h"
#include "grammar/symbols.h"
#include "grammar/text_file.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace isl::grammar {

/// One parsed file. `span` is its whole text; `file` its place as the user would say it (relative to the current folder
/// where the scene's was), or the name that was given to a text without one.
struct Unit {
  SourceSpan span;
  Items items;
  std::filesystem::path file;
  /// The errors of the text that hold whatever is executed: those in no branch and no macro's body.
  std::vector<const Complaint*> errors;
};

/// A file that the scene is made of. What the run itself wrote is none.
struct UsedFile {
  std::string name;             ///< the same on every machine: from the scene's folder, or from that of the library
  std::filesystem::path shown;  ///< as the user would say it
  std::uint64_t hash = 0;       ///< of its content (base/content_hash.h)
};

struct LoaderOptions {
  /// Where files are looked for after the folder of the file that asks. These folders, the scene's own and what is
  /// below them are all that a scene may read.
  std::vector<std::filesystem::path> include_paths = {};
  /// Below these a scene may write.
  std::vector<std::filesystem::path> write_folders = {};
  /// Brackets and directives that may be open at once. Trees are at most four times as high.
  std::size_t max_nesting = 1000;
  std::size_t max_file_bytes = 256u << 20;
  /// Of the texts read and their trees, for each.
  std::size_t max_memory_bytes = std::size_t{4} << 30;
};

enum class LoadError { none, not_found, not_readable, too_large, syntax };

/// Every load_ function gives nullptr only if there was no text to parse, which is reported. What is wrong with a text
/// stands in its tree, where whoever executes it finds it (ast.h, Error); `last_error()` tells of errors that hold
/// whatever is executed. Nothing may be moved away
/// under it: it keeps references to all it is given. Not thread-safe.
class Loader {
 public:
  Loader(SourceMap& map, SymbolTable& symbols, Arena& arena, DiagnosticSink& sink, LoaderOptions options);

  /// The scene; `-` is standard input, whose includes are looked for in the current folder.
  [[nodiscard]] const Unit* load_scene(const std::filesystem::path& file_or_dash);

  /// A text that stands in no file, for tests and `-D`. Never cached.
  [[nodiscard]] const Unit* load_text(std::string name, std::string text);

  /// The file that `#include name` in `from` means. `where` is blamed when there is none. A file that has not changed
  /// since it was parsed is not parsed again.
  [[nodiscard]] const Unit* load_include(std::string_view name, SourceSpan where, const Unit& from);

  /// The values of the file that `#fopen name … read` in `from` means; null where there is none, and `problem` says
  /// why.
  [[nodiscard]] std::unique_ptr<DataFile> open_data(std::string_view name, const Unit& from, AccessProblem& problem);

  /// Reads the file `name` that a scene in `from` takes pictures, densities or letters from, as far as it takes to name
  /// it among used_files(). False where it cannot be read, and `problem` says why.
  [[nodiscard]] bool use_file(std::string_view name, const Unit& from, AccessProblem& problem);

  /// Every file read so far, in the order of first use.
  [[nodiscard]] const std::vector<UsedFile>& used_files() const { return used_; }

  /// Whether a file could be read by that name.
  [[nodiscard]] bool exists(std::string_view name, const Unit& from) const;

  /// Where files may stand: for what is read or written beside scenes and their includes.
  [[nodiscard]] FileAccess& access() { return access_; }

  /// What the files of the search path declare; they are read at the first call.
  [[nodiscard]] const LibraryIndex& library();

  /// Bytes of all texts read and of their trees. They stay as long as the run.
  [[nodiscard]] std::size_t bytes_held() const { return text_bytes_ + arena_.bytes(); }

  /// Drops what is remembered of a file, because the scene has just written it (a clock's tick may be too coarse to
  /// tell).
  void forget(const std::filesystem::path& file);

  /// What is wrong with all texts, whether it is ever executed or not.
  [[nodiscard]] const std::deque<Complaint>& complaints() const { return complaints_; }
  /// All that were parsed.
  [[nodiscard]] const std::deque<Unit>& units() const { return units_; }

  /// How the last load_ went.
  [[nodiscard]] LoadError last_error() const { return last_error_; }

 private:
  struct Cached {
    const Unit* unit;
    LoadError error;
    FileStamp stamp;
  };

  struct CachedData {
    SourceSpan span;
    FileStamp stamp;
  };

  const Unit* fail(LoadError error, SourceSpan where, std::string message, std::string hint = {});
  const Unit* parse(std::string name, std::filesystem::path file, std::string text, SourceSpan where);
  const Unit* load_file(const FoundFile& file, SourceSpan where);
  [[nodiscard]] FoundFile find_include(std::string_view name, const Unit& from) const;
  /// Notes that a file was read. `name` is its portable name; a file without one is not noted.
  void note_use(std::string name, std::filesystem::path shown, std::string_view content);
  /// Nothing where the limit or the offsets of the source map are used up, and `problem` says so.
  std::optional<SourceSpan> keep_text(std::string name, std::string text, AccessProblem& problem);

  SourceMap& map_;
  SymbolTable& symbols_;
  Arena& arena_;
  DiagnosticSink& sink_;
  LoaderOptions options_;
  FileAccess access_;
  std::optional<LibraryIndex> library_;
  std::deque<Unit> units_;
  std::deque<Complaint> complaints_;               ///< the trees point into it
  std::unordered_map<std::string, Cached> cache_;  ///< by canonical path
  std::unordered_map<std::string, CachedData> data_;
  std::unordered_map<std::string, FileStamp> used_bytes_;  ///< by canonical path: files that use_file() has read
  std::vector<UsedFile> used_;
  std::set<std::pair<std::string, std::uint64_t>> used_keys_;  ///< name and hash of each in `used_`
  std::size_t text_bytes_ = 0;
  LoadError last_error_ = LoadError::none;
};

}  // namespace isl::grammar
