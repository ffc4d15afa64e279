// Tokens as the parser is to see them. Between the scanner and the parser, it
// - complains of brackets and directives that do not match, and mends them, so that one mistake is one message and what
//   stands in a branch or a macro's body stays there;
// - limits their nesting, since neither the parser's stack nor the evaluator's is endless;
// - gives operators within `function {}` their other kinds, which have other precedences;
// - skips to the end of a parenthesis in which the parser has found a mistake.
#pragma once

#include "base/diagnostic.h"
#include "grammar/complaints.h"
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
  /// `lexer` reports to `scanned`, from where its complaints are moved on.
  TokenStream(Lexer& lexer, DiagnosticSink& scanned, const SymbolTable& symbols, Complaints& complaints,
              std::size_t max_nesting);

  /// Brackets and directives match in what this gives. Ends early after too many errors. Throws ScannerFailure.
  [[nodiscard]] Token next();

  /// The parser has just found the last token wrong: within `(` or `[`, the next one is what closes it. Throws
  /// ScannerFailure.
  void skip_mistake();

  /// The last token does not stand in the text: what is wrong there was complained of.
  [[nodiscard]] bool is_mending() const { return mending_; }
  /// What was wrong, where the last token stands for that; may be null.
  [[nodiscard]] const Complaint* last_complaint() const { return last_complaint_; }

 private:
  [[nodiscard]] Token scan();
  [[nodiscard]] Token take();
  [[nodiscard]] Token take_from_text();
  void skip_deprecation();

  [[nodiscard]] Token send();
  [[nodiscard]] Token finish();
  void follow(Token token);
  [[nodiscard]] bool is_passed_over(const Token& token);
  [[nodiscard]] bool is_too_deep(const Token& token);
  void close_all(const std::vector<Opening>& openings, const Complaint* complaint);
  [[nodiscard]] const Complaint* complain_unclosed(const Verdict& verdict, const Token& found);
  void complain_half_split(const Opening& directive);
  void complain_stray(const Token& token);
  [[nodiscard]] std::string name_of(const Opening& macro) const;

  struct Arranged {
    Token token;
    bool mended;
  };

  Lexer& lexer_;
  DiagnosticSink& scanned_;
  const SymbolTable& symbols_;
  Complaints& complaints_;
  std::size_t max_nesting_;
  Nesting nesting_;
  std::deque<Token> ahead_;         ///< read from the text but not yet followed
  std::deque<Arranged> arranged_;   ///< ready for the parser
  std::vector<Token> passed_over_;  ///< misspelt directives, for the messages of what they leave unmatched
  SourceSpan last_span_;            ///< of the last token of the text
  std::size_t depth_before_ = 0;    ///< of the nesting, before the last token
  const Complaint* last_complaint_ = nullptr;
  bool begins_stretch_ = false;  ///< the last token shapes a directive
  bool mending_ = false;
  bool skipping_ = false;
  bool too_deep_ = false;
};

}  // namespace isl::grammar
