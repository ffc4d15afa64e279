// Text files → syntax trees: finds a file, reads it, runs the parser, and caches the result. The evaluator calls it at
// each `#include`, and cli calls it once for the scene. It knows from which folders files may be read, and nothing of
// their meaning.
#pragma once

#include "base/diagnostic.h"
#include "base/run_limits.h"
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
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace isl::grammar {

/// One parsed file. `span` is its whole text; `file` is its path as the user would say it (relative to the current
/// folder if the scene's was), or the name that was given to a text without a file.
struct Unit {
  SourceSpan span;
  Items items;
  std::filesystem::path file;
  /// The errors of the text that apply whatever is executed: those in no branch and no macro's body.
  std::vector<const Complaint*> errors;
};

/// A file that the scene depends on. A file that the run itself wrote is not listed.
struct UsedFile {
  std::string name;             ///< portable name: relative to the scene's folder or to that of the library
  std::filesystem::path shown;  ///< as the user would say it
  std::uint64_t hash = 0;       ///< of its content (base/content_hash.h)
};

struct LoaderOptions {
  /// A scene may read and write only in these folders, and read in its own.
  AllowedFolders folders = {};
  /// The run's outputs, which those of the scene join, and its register of files.
  std::shared_ptr<OutputSet> outputs = std::make_shared<OutputSet>();
  /// Limit of simultaneously open brackets and directives. Trees are at most four times as high.
  std::size_t max_nesting = 1000;
  std::size_t max_file_bytes = 256u << 20;
  /// The budget is charged with source texts and syntax trees, and outlives them. Once the flag is set, reading ends.
  RunLimits run = {};
};

enum class LoadError { none, not_found, not_readable, too_large, syntax };

/// Every load_ function returns nullptr only if there was no text to parse, and reports that. A mistake in a text
/// becomes a node in its tree, and execution reports it when it gets there (ast.h, Error); `last_error()` tells of
/// errors that apply whatever is executed. The loader keeps references to all its constructor's arguments: none of them
/// may be moved. Not thread-safe.
class Loader {
 public:
  Loader(SourceMap& map, SymbolTable& symbols, Arena& arena, DiagnosticSink& sink, LoaderOptions options);

  /// Loads the scene; `-` is standard input, whose includes are searched in the current folder.
  [[nodiscard]] const Unit* load_scene(const std::filesystem::path& file_or_dash);

  /// Loads a text that is not in a file, for tests and `-D`. It is never cached.
  [[nodiscard]] const Unit* load_text(std::string name, std::string text);

  /// Loads the file that `#include name` in `from` means. `where` is the place of the error if there is none. A file
  /// that has not changed since it was parsed is not parsed again.
  [[nodiscard]] const Unit* load_include(std::string_view name, SourceSpan where, const Unit& from);

  /// Opens the values of the file that `#fopen name … read` in `from` means; null if there is none, and `problem` says
  /// why.
  [[nodiscard]] std::unique_ptr<DataFile> open_data(std::string_view name, const Unit& from, AccessProblem& problem);

  /// Reads the file `name`, which a scene in `from` uses for pictures, densities or letters, so that it appears in
  /// used_files(). Returns its bytes, which the budget is charged with as long as someone holds them; null if it cannot
  /// be read, and `problem` says why.
  [[nodiscard]] std::shared_ptr<const std::string> use_file(std::string_view name, const Unit& from,
                                                            AccessProblem& problem);

  /// Every file read so far, in the order of first use.
  [[nodiscard]] const std::vector<UsedFile>& used_files() const { return used_; }

  /// The size of the largest file that may be read now.
  [[nodiscard]] std::size_t max_file_bytes() const;

  /// True if a file by that name could be read.
  [[nodiscard]] bool exists(std::string_view name, const Unit& from) const;

  /// The rules for other files that are read or written, beside scenes and their includes.
  [[nodiscard]] FileAccess& access() { return access_; }

  /// The names that the files of the search path declare; these are read at the first call.
  [[nodiscard]] const LibraryIndex& library();

  /// All complaints about all texts, whether their text is executed or not.
  [[nodiscard]] const std::deque<Complaint>& complaints() const { return complaints_; }
  /// All parsed files.
  [[nodiscard]] const std::deque<Unit>& units() const { return units_; }

  /// The outcome of the last load_.
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

  struct CachedBytes {
    std::weak_ptr<const std::string> bytes;
    FileStamp stamp;
  };

  const Unit* fail(LoadError error, SourceSpan where, std::string message, std::string hint = {});
  const Unit* parse(std::string name, std::filesystem::path file, std::string text, SourceSpan where);
  struct Parsed {
    Items items;
    std::vector<const Complaint*> errors;  ///< as Unit::errors
    bool has_unmatched_brace = false;
  };
  /// Parses a text of the map; `parted_braces` as in TokenStream.
  Parsed parse(SourceSpan span, std::span<const std::uint32_t> parted_braces);
  const Unit* load_file(const FoundFile& file, SourceSpan where);
  [[nodiscard]] FoundFile find_include(std::string_view name, const Unit& from) const;
  /// Records that a file was read. `name` is its portable name; a file without one is not recorded.
  void note_use(std::string name, std::filesystem::path shown, std::string_view content);
  /// Notes a file that was read as an input. False: the run writes it, and `problem` says so.
  bool note_input(const FoundFile& found, const TextFile& file, AccessProblem& problem);
  /// Adds a hint if a file was refused for its size, and would not be with more memory.
  void explain(TextFile& file, std::size_t max_bytes) const;
  /// Returns nothing if the limit or the offsets of the source map are used up, and `problem` says so.
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
  std::unordered_map<std::string, CachedBytes> used_bytes_;  ///< by canonical path: files that use_file() has read
  std::vector<UsedFile> used_;
  std::set<std::pair<std::string, std::uint64_t>> used_keys_;  ///< name and hash of each in `used_`
  Charge texts_;                                               ///< kept for the whole run
  LoadError last_error_ = LoadError::none;
};

}  // namespace isl::grammar
