// Which brackets and directives are open, and what a closing token that does not fit them means. Stands in the token
// stream, before the parser, which therefore only ever sees text whose brackets match.
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
  bool in_function = false;  ///< within the braces of a `function {}`: other precedences hold
  Symbol name = kNoSymbol;   ///< of a `#macro`
  bool has_elseif = false;   ///< of an `#if`
  bool has_else = false;     ///< of a directive
  bool has_head = false;     ///< of a directive: its parenthesis was closed
  SourceSpan split_brace =
      {};  ///< of an `#if` whose first branch opens a block: `#if (c) merge { #else union { #end … }`
  SourceSpan split_else = {};  ///< and the `#else` after it

  [[nodiscard]] bool is_split() const { return !split_brace.empty(); }
};

/// What must happen before a token may be passed on.
struct Verdict {
  /// Closing tokens to put before it, innermost first; they are taken off already.
  std::vector<Opening> unclosed;
  /// Where the bracket stands that it closes.
  std::optional<std::uint32_t> closed = std::nullopt;
  /// `#else`, `#case` and the like in a directive that it cannot divide, or not any more.
  bool misplaced = false;
  /// It closes nothing: leave it out.
  bool stray = false;
  /// The directive that it ends, where it is `#end`.
  std::optional<Opening> ended = std::nullopt;
  /// The first branch of the `#if` that it ends opened a block, and the second did not.
  bool half_split = false;
};

class Nesting {
 public:
  /// Follows one token. It must be passed on as the verdict says.
  Verdict follow(const Token& token);

  [[nodiscard]] bool empty() const { return open_.empty(); }
  [[nodiscard]] std::size_t depth() const { return open_.size(); }
  /// From the outermost to the innermost.
  [[nodiscard]] const std::vector<Opening>& open() const { return open_; }
  /// The directive that the next token stands in; null outside of all.
  [[nodiscard]] const Opening* innermost_directive() const;
  [[nodiscard]] bool in_function() const { return !open_.empty() && open_.back().in_function; }
  /// No branch, loop or macro's body is open: what stands here is executed. A directive's own parenthesis is.
  [[nodiscard]] bool is_outside() const { return bodies_ == 0; }
  void clear() {
    open_.clear();
    bodies_ = 0;
  }

 private:
  void push(const Token& token);
  [[nodiscard]] bool has_just_opened_block() const;
  Verdict close_bracket(TokenKind opener);
  Verdict reach_directive(const Token& token);

  std::vector<Opening> open_;
  std::size_t bodies_ = 0;  ///< open directives whose parenthesis was closed
  TokenKind previous_ = Parser::token::TOK_END_OF_FILE;
  TokenKind before_previous_ = Parser::token::TOK_END_OF_FILE;
  TokenKind third_last_ = Parser::token::TOK_END_OF_FILE;
  bool function_pending_ = false;  ///< `function` seen, its brace not yet
};

/// The token that closes an opening.
[[nodiscard]] TokenKind closer_of(TokenKind opener);

/// As the user types it: `{`, `#if`, `#end` …
[[nodiscard]] std::string_view spelling(TokenKind kind);

/// `{`, `(` and `[`.
[[nodiscard]] bool opens_bracket(TokenKind kind);

/// Of the directives that end with `#end`.
[[nodiscard]] bool opens_directive(TokenKind kind);

/// Of those, what divides them, and `#end`.
[[nodiscard]] bool shapes_directive(TokenKind kind);

}  // namespace isl::grammar
