// All source text of a run as one virtual text: a 32-bit offset names a byte of a file, and only this module turns it
// into a file name, a line and a column. The whole flow uses it: the lexer reads from it, messages point into it.
//
// Offset 0 means nowhere, the first file starts at 1, and each file owns one offset past its last byte (its end).
#pragma once

#include "base/source_span.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isl::grammar {

/// Numbered from 1; columns count characters of UTF-8, and a stray byte counts together with the character before it.
/// Line 0 means nowhere.
struct SourcePosition {
  std::string_view file;
  std::size_t line = 0;
  std::size_t column = 0;
};

/// Owns names and texts; views into it stay valid as long as it does. Not thread-safe: lines are found on demand.
class SourceMap {
 public:
  SourceMap() = default;
  SourceMap(const SourceMap&) = delete;
  SourceMap& operator=(const SourceMap&) = delete;

  /// Adds a file. Returns the span of its text, or nothing when the offsets of 32 bits are used up.
  [[nodiscard]] std::optional<SourceSpan> add(std::string name, std::string text);

  /// Line 0 for an offset that belongs to no file.
  [[nodiscard]] SourcePosition position(std::uint32_t offset) const;

  /// The line that holds the offset, without its line end; empty for an offset of no file.
  [[nodiscard]] std::string_view line_text(std::uint32_t offset) const;

  /// The text of a span within one file, cut to that file; a view into the same text as line_text.
  [[nodiscard]] std::string_view text(SourceSpan span) const;

 private:
  struct File {
    std::string name;
    std::string text;
    std::uint32_t begin;
    std::vector<std::uint32_t> line_starts;  ///< relative to begin; computed at the first query
  };

  [[nodiscard]] const File* find(std::uint32_t offset) const;
  /// The index in line_starts of the line that holds a place relative to the file.
  [[nodiscard]] static std::size_t line_index(const File& file, std::uint32_t place);

  mutable std::deque<File> files_;  // mutable only for the line starts, which are found lazily
  std::uint32_t next_begin_ = 1;
};

}  // namespace isl::grammar
