// Tokens as the parser is to see them. Between the scanner and the parser, it
// - reports brackets and directives that do not match, and mends them, so that one mistake is one message;
// - limits their nesting, since neither the parser's stack nor the evaluator's is endless;
// - sets aside a macro's body that opens or closes what is not its own: an error only where the macro is called;
// - gives operators within `function {}` their other kinds, which have other precedences;
// - skips to the end of a parenthesis in which the parser has found a mistake.
#pragma once

#include "base/diagnostic.h"
#include "grammar/arena.h"
#include "grammar/lexer.h"
#include "grammar/nesting.h"
#include "grammar/token.h"

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

namespace isl::grammar {

class TokenStream {
 public:
  TokenStream(Lexer& lexer, const SymbolTable& symbols, Arena& arena, DiagnosticSink& sink, std::size_t max_nesting);

  /// Brackets and directives match in what this gives. Ends early after too many errors. Throws ScannerFailure.
  [[nodiscard]] Token next();

  /// The parser has just found the last token wrong: within `(` or `[`, the next one is what closes it. Throws
  /// ScannerFailure.
  void skip_mistake();

  /// The last token does not stand in the text: what is wrong there was reported.
  [[nodiscard]] bool is_mending() const { return mending_; }

 private:
  [[nodiscard]] Token take();
  [[nodiscard]] Token take_from_text();
  void skip_deprecation();
  void read_macro();
  void set_aside_unbalanced_body();
  [[nodiscard]] std::optional<Token> check_body(std::size_t begin) const;

  [[nodiscard]] Token send();
  [[nodiscard]] Token finish();
  void close_all(const std::vector<Opening>& openings);
  void report_unclosed(const std::vector<Opening>& unclosed, const Token& found);
  void report_stray(const Token& token);

  struct Arranged {
    Token token;
    bool mended;
  };

  Lexer& lexer_;
  const SymbolTable& symbols_;
  Arena& arena_;
  DiagnosticSink& sink_;
  std::size_t max_nesting_;
  Nesting nesting_;
  std::deque<Token> ahead_;        ///< read from the text but not yet followed: the rest of a macro
  std::deque<Arranged> arranged_;  ///< ready for the parser
  SourceSpan last_span_;           ///< of the last token of the text
  std::size_t depth_before_ = 0;   ///< of the nesting, before the last token
  bool mending_ = false;
  bool skipping_ = false;
  bool too_deep_ = false;
};

}  // namespace isl::grammar
