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
#include <cstdint>
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

  /// The parser has just found the last token wrong. True where that may follow from the mistake before: fewer than
  /// three tokens were right since then, and no statement ended.
  [[nodiscard]] bool meet_mistake();
  /// And then: within `(` or `[`, the next token is what closes it. Throws ScannerFailure.
  void skip_mistake();
  /// The token that was wrong means nothing to the parser now either.
  [[nodiscard]] bool drops_wrong();
  /// It was found wrong more often than there is anything to give up because of it.
  [[nodiscard]] bool is_stuck() const { return wrong_in_turn_ > sent_; }
  /// A statement has ended: what is wrong after it does not follow from what was before.
  void end_statement() {
    right_since_ = sent_;
    in_doubt_ = false;
  }

  /// The last token does not stand in the text: what is wrong there was complained of.
  [[nodiscard]] bool is_mending() const { return last_.mended; }
  /// What was wrong, where the last token stands for that; may be null.
  [[nodiscard]] const Complaint* last_complaint() const { return last_.token.complaint; }

 private:
  [[nodiscard]] Token scan();
  [[nodiscard]] Token take();

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
    Token token = {};
    bool mended = false;
    std::optional<std::uint32_t> closes = {};  ///< where the bracket stands that it closes
    bool misplaced = false;                    ///< as Verdict::misplaced
  };

  Lexer& lexer_;
  DiagnosticSink& scanned_;
  const SymbolTable& symbols_;
  Complaints& complaints_;
  std::size_t max_nesting_;
  Nesting nesting_;
  TokenKind taken_ = Parser::token::TOK_END_OF_FILE;  ///< the kind of the last token of the text
  std::deque<Arranged> arranged_;                     ///< ready for the parser
  std::vector<Token> passed_over_;  ///< misspelt directives, for the messages of what they leave unmatched
  SourceSpan last_span_;            ///< of the last token of the text
  std::size_t depth_before_ = 0;    ///< of the nesting, before the last token
  Arranged last_;                   ///< what the parser has
  std::size_t sent_ = 0;            ///< so many tokens the parser has been given
  std::size_t wrong_at_ = 0;        ///< sent_ when the parser last found one wrong
  std::size_t wrong_in_turn_ = 0;   ///< so often it found the same one wrong again
  std::size_t right_since_ = 0;     ///< the tokens after so many were right
  bool in_doubt_ = false;           ///< a mistake was met, and no statement has ended since
  bool begins_stretch_ = false;     ///< the last token shapes a directive
  std::size_t skipping_from_ = 0;   ///< how deep the bracket is whose rest is being skipped; 0 where none is
  bool skipped_ = false;            ///< what is left of the bracket with the last mistake
  bool too_deep_ = false;
};

}  // namespace isl::grammar
