// The stack of open brackets and directives, and the verdict on a closing token that does not fit them. It works in the
// token stream, before the parser, which therefore only ever sees text whose brackets match.
//
// `<` and `>` are no brackets here: only the grammar can tell a vector from a comparison.
#pragma once

#include "base/source_span.h"
#include "grammar/token.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace isl::grammar {

/// A bracket or directive that waits for its end.
struct Opening {
  TokenKind kind;
  SourceSpan span;
  bool in_function = false;  ///< within the braces of a `function {}`: other precedences apply
  Symbol name = kNoSymbol;   ///< name of a `#macro`
  bool has_else = false;     ///< a directive had its `#else`
  bool has_head = false;     ///< a directive's parenthesis was closed
};

/// The steps that are necessary before a token may be passed on.
struct Verdict {
  /// Closing tokens to insert before it, innermost first; they are popped already.
  std::vector<Opening> unclosed;
  /// The place of the bracket that it closes.
  std::optional<std::uint32_t> closed = std::nullopt;
  /// True for an `#else`, `#case` and the like in a directive that it cannot divide, or not any more.
  bool misplaced = false;
  /// True if it closes nothing and must be left out.
  bool stray = false;
  /// The directive that it ends, if it is `#end`.
  std::optional<Opening> ended = std::nullopt;
};

class Nesting {
 public:
  /// Processes one token. The caller must pass it on as the verdict says.
  Verdict follow(const Token& token);

  [[nodiscard]] bool empty() const { return open_.empty(); }
  [[nodiscard]] std::size_t depth() const { return open_.size(); }
  /// The open brackets and directives, from the outermost to the innermost.
  [[nodiscard]] const std::vector<Opening>& open() const { return open_; }
  /// The directive that contains the next token; null outside all.
  [[nodiscard]] const Opening* innermost_directive() const;
  [[nodiscard]] bool in_function() const { return !open_.empty() && open_.back().in_function; }
  /// True if no branch, loop or macro's body is open: this text is executed. A directive's own parenthesis is executed,
  /// too.
  [[nodiscard]] bool is_outside() const { return bodies_ == 0; }
  void clear() {
    open_.clear();
    bodies_ = 0;
  }

 private:
  void push(const Token& token);
  Verdict close_bracket(TokenKind opener);
  Verdict reach_directive(const Token& token);

  std::vector<Opening> open_;
  std::size_t bodies_ = 0;  ///< open directives whose parenthesis was closed
  TokenKind previous_ = Parser::token::TOK_END_OF_FILE;
  bool function_pending_ = false;  ///< `function` was seen, its brace not yet
};

/// The token that closes an opening.
[[nodiscard]] TokenKind closer_of(TokenKind opener);

/// The token as the user types it: `{`, `#if`, `#end` …
[[nodiscard]] std::string_view spelling(TokenKind kind);

/// True for `{`, `(` and `[`.
[[nodiscard]] bool opens_bracket(TokenKind kind);

/// True for the directives that end with `#end`.
[[nodiscard]] bool opens_directive(TokenKind kind);

/// True for those directives, for the tokens that divide them, and for `#end`.
[[nodiscard]] bool shapes_directive(TokenKind kind);

}  // namespace isl::grammar
