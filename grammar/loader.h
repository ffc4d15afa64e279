// Text files → syntax trees: finds a file, reads it, runs the parser, and remembers the result. What the evaluator asks
// at each `#include` and cli asks once for the scene. Knows where files may be read from, and nothing of what they
// mean.
#pragma once

#include "base/diagnostic.h"
#include "grammar/arena.h"
#include "grammar/ast.h"
#include "grammar/source_map.h"
#include "grammar/symbols.h"
#include "grammar/text_file.h"

#include <cstddef>
#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace isl::grammar {

/// One parsed file. `span` is its whole text; `file` its place as the user would say it (relative to the current folder
/// where the scene's was), or the name that was given to a text without one.
struct Unit {
  SourceSpan span;
  Items items;
  std::filesystem::path file;
};

struct LoaderOptions {
  /// Where includes are looked for after the including file's folder. These folders, the scene's own and what is below
  /// them are all that an include may read.
  std::vector<std::filesystem::path> include_paths;
  /// Brackets and directives that may be open at once. Trees are at most four times as high.
  std::size_t max_nesting = 1000;
  std::size_t max_file_bytes = 256u << 20;
};

enum class LoadError { none, not_found, not_readable, syntax };

/// Every load_ function gives nullptr only if there was no text to parse, which is reported; after syntax errors it
/// gives what could still be parsed, the errors being in the sink and `last_error()` telling. Nothing may be moved away
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

  /// Drops what is remembered of a file, because the scene has just written it (a clock's tick may be too coarse to
  /// tell).
  void forget(const std::filesystem::path& file);

  /// How the last load_ went.
  [[nodiscard]] LoadError last_error() const { return last_error_; }

 private:
  struct Cached {
    const Unit* unit;
    LoadError error;
    FileStamp stamp;
  };

  const Unit* fail(LoadError error, SourceSpan where, std::string message, std::string hint = {});
  const Unit* parse(std::string name, std::filesystem::path file, std::string text, SourceSpan where);
  const Unit* load_file(const std::filesystem::path& found, const std::filesystem::path& canonical, SourceSpan where);
  [[nodiscard]] bool may_read(const std::filesystem::path& canonical) const;
  void allow(const std::filesystem::path& folder);

  SourceMap& map_;
  SymbolTable& symbols_;
  Arena& arena_;
  DiagnosticSink& sink_;
  LoaderOptions options_;
  std::vector<std::filesystem::path> allowed_;  ///< canonical folders
  std::deque<Unit> units_;
  std::unordered_map<std::string, Cached> cache_;  ///< by canonical path
  LoadError last_error_ = LoadError::none;
};

}  // namespace isl::grammar
