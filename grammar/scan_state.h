// The actions of the scanner's rules: place, strings, comments, and the token for each piece of text. The rules in
// lexer.ll contain only regular expressions; everything with an `if` is here.
#pragma once

#include "base/diagnostic.h"
#include "grammar/arena.h"
#include "grammar/symbols.h"
#include "grammar/token.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isl::grammar {

class ScanState {
 public:
  ScanState(std::string_view text, std::uint32_t begin, SymbolTable& symbols, Arena& arena, DiagnosticSink& sink);

  /// Moves on by the bytes that the scanner has matched.
  void advance(std::size_t bytes);

  // Tokens of the text just matched. An optional one is empty if the text was reported and must be left out.
  [[nodiscard]] Token simple(TokenKind kind) const { return {.kind = kind, .span = span()}; }
  [[nodiscard]] Token word(std::string_view text);
  [[nodiscard]] Token number(std::string_view text);
  /// `#word`; a misspelt one is taken for the nearest and marked so, and a name before `(` is taken for a macro's.
  [[nodiscard]] std::optional<Token> directive(std::string_view text);
  /// An operator of other languages (`==`): reported, and replaced by the intended one.
  [[nodiscard]] Token foreign(TokenKind meant, std::string_view written, std::string_view right);
  void bad_character(std::string_view text);
  void stray_comment_end();
  /// A `#` before no name: POV-Ray ignores it in silence.
  void lone_hash();

  void open_comment() { comment_openings_.push_back(span()); }
  /// True when the outermost comment is closed.
  [[nodiscard]] bool close_comment();
  void unclosed_comment();

  void open_string();
  /// A backslash and the character after it, which is missing at the end of a line.
  void escape(std::string_view text);
  /// The string goes on in the next line: any line end within a string becomes a line feed.
  void line_end_in_string(std::string_view text);
  /// `characters` replace a piece of the text whose spelling differs from them.
  void replace_in_string(std::string_view characters);
  [[nodiscard]] Token close_string();
  [[nodiscard]] Token unclosed_string();

  [[nodiscard]] Token end_of_file() const;

  /// True if the text ended within a comment or string.
  [[nodiscard]] bool is_cut_off() const { return is_cut_off_; }

 private:
  [[nodiscard]] SourceSpan span() const { return {begin_, end_}; }
  [[nodiscard]] std::string_view text_between(std::uint32_t begin, std::uint32_t end) const;
  /// Reports an error unless there are enough: between two tokens the scanner may meet any number.
  void complain(SourceSpan span, std::string message, std::string hint = {});
  void copy_string_until(std::uint32_t place);

  std::string_view text_;
  std::uint32_t file_begin_;
  std::uint32_t begin_;  ///< start of the text just matched
  std::uint32_t end_;
  std::uint32_t string_begin_ = 0;  ///< the opening quote
  std::uint32_t copied_until_ = 0;  ///< the string is copied into string_text_ up to here
  std::string string_text_;
  bool is_cut_off_ = false;
  bool string_differs_ = false;  ///< the string differs from its spelling, so that string_text_ is needed
  std::vector<SourceSpan> comment_openings_;
  SymbolTable& symbols_;
  Arena& arena_;
  DiagnosticSink& sink_;
};

}  // namespace isl::grammar
