// The comments of a library in the form that stdlib/README.md describes: what the file declares, and the text that
// explains it. Knows lines of text, and nothing of folders or output; bench/library_comments.py reads the same for
// scripts.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace isl::cli {

/// A macro or a declaration with its comment.
struct LibraryEntry {
  std::string name;
  std::string kind;                     ///< `macro`, or the word of the comment: `texture`, `colour` …
  std::vector<std::string> parameters;  ///< names; empty for a declaration
  std::vector<std::string> text;        ///< lines: what it does, then what its parameters mean
  std::vector<std::string> example;     ///< lines; empty for a declaration
  std::size_t line = 0;                 ///< of the directive, counted from 1
};

/// The entries of a file named `stem`.isl, in its order. A macro or declaration whose comment has another form is not
/// listed, nor is a name that serves the file alone (`Curves_Isl_…` in curves.isl).
[[nodiscard]] std::vector<LibraryEntry> library_entries(std::string_view stem, std::string_view text);

/// The lines of the comment that a file begins with; none if it begins with something else.
[[nodiscard]] std::vector<std::string> head_comment(std::string_view text);

/// The first sentence of such a comment, in one line.
[[nodiscard]] std::string first_sentence(const std::vector<std::string>& comment);

}  // namespace isl::cli
