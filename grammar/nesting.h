// Which brackets and directives are open, and what a closing token that does not fit them means. Stands in the token
// stream, before the parser, which therefore only ever sees text whose brackets match.
//
// `<` and `>` are no brackets here: only the grammar can tell a vector from a comparison.
#pragma once

#include "base/source_span.h"
#include "grammar/token.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace isl::grammar {

/// A bracket or directive that waits for its end.
struct Opening {
  TokenKind kind;
  SourceSpan span;
  bool in_function = false;  ///< within the braces of a `function {}`: other precedences hold
  bool split = false;        ///< an `#if` whose first branch opened a block: `#if (c) merge { #else union { #end … }`
};

/// What must happen before a token may be passed on.
struct Verdict {
  /// Closing tokens to put before it, innermost first; they are taken off already.
  std::vector<Opening> unclosed;
  /// It closes nothing: leave it out.
  bool stray = false;
};

class Nesting {
 public:
  /// Follows one token. It must be passed on as the verdict says.
  Verdict follow(const Token& token);

  [[nodiscard]] bool empty() const { return open_.empty(); }
  [[nodiscard]] std::size_t depth() const { return open_.size(); }
  /// From the outermost to the innermost.
  [[nodiscard]] const std::vector<Opening>& open() const { return open_; }
  [[nodiscard]] bool in_function() const { return !open_.empty() && open_.back().in_function; }
  void clear() { open_.clear(); }

 private:
  void push(const Token& token);
  Verdict close_bracket(TokenKind opener);
  Verdict reach_directive(TokenKind kind);

  std::vector<Opening> open_;
  TokenKind previous_ = Parser::token::TOK_END_OF_FILE;
  bool function_pending_ = false;  ///< `function` seen, its brace not yet
};

/// The token that closes an opening.
[[nodiscard]] TokenKind closer_of(TokenKind opener);

/// As the user types it: `{`, `#if`, `#end` …
[[nodiscard]] std::string_view spelling(TokenKind kind);

/// Of the directives that end with `#end`.
[[nodiscard]] bool opens_directive(TokenKind kind);

}  // namespace isl::grammar
