// Tokens as the parser must see them. Between the scanner and the parser, it
// - reports brackets and directives that do not match, and mends them, so that one mistake is one message and the
//   contents of a branch or a macro's body stay there;
// - gives the words of POV-Ray 3.8 their meaning where the tokens around them allow no other;
// - limits their nesting, since neither the parser's stack nor the evaluator's is endless;
// - gives operators within `function {}` their other kinds, which have other precedences;
// - skips to the end of a parenthesis in which the parser has found a mistake.
#pragma once

#include "base/diagnostic.h"
#include "base/stop_flag.h"
#include "grammar/complaints.h"
#include "grammar/lexer.h"
#include "grammar/nesting.h"
#include "grammar/token.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace isl::grammar {

class TokenStream {
 public:
  /// `lexer` reports to `scanned`, from which its complaints are moved on. Braces at the places `parted` are no
  /// brackets (parted_braces.h). `stop` ends the text early; it may be null.
  TokenStream(Lexer& lexer, DiagnosticSink& scanned, const SymbolTable& symbols, Complaints& complaints,
              std::size_t max_nesting, std::span<const std::uint32_t> parted = {}, const StopFlag* stop = nullptr);

  /// The next token; brackets and directives always match. Ends early after too many errors. Throws ScannerFailure.
  [[nodiscard]] Token next();

  /// The parser has just rejected the last token. True if that may follow from the mistake before: fewer than three
  /// tokens were right since then, and no statement ended.
  [[nodiscard]] bool meet_mistake();
  /// Called next: within `(` or `[`, the next token is the one that closes it. Throws ScannerFailure.
  void skip_mistake();
  /// True if the parser still cannot use the rejected token.
  [[nodiscard]] bool drops_wrong();
  /// True if it was rejected more often than there are tokens to give up.
  [[nodiscard]] bool is_stuck() const { return wrong_in_turn_ > sent_; }
  /// A statement has ended: a later mistake does not follow from an earlier one.
  void end_statement() {
    right_since_ = sent_;
    in_doubt_ = false;
  }

  /// True if a directive ended before a brace within it was closed, or a brace was closed that is not open there.
  [[nodiscard]] bool has_unmatched_brace() const { return has_unmatched_brace_; }

  /// True if the last token was inserted and is not in the text: the mistake there was reported.
  [[nodiscard]] bool is_mending() const { return last_.mended; }
  /// The complaint that the last token represents; may be null.
  [[nodiscard]] const Complaint* last_complaint() const { return last_.token.complaint; }

 private:
  [[nodiscard]] Token scan();
  [[nodiscard]] Token next_of_text();
  /// The token `distance` places after the last one that was taken.
  [[nodiscard]] const Token& look_ahead(std::size_t distance);
  [[nodiscard]] Token as_newer_word(Token token);
  [[nodiscard]] Token take();

  [[nodiscard]] Token send();
  [[nodiscard]] Token finish();
  void follow(Token token);
  [[nodiscard]] bool is_passed_over(const Token& token);
  [[nodiscard]] bool is_too_deep(const Token& token);
  void close_all(const std::vector<Opening>& openings, const Complaint* complaint);
  [[nodiscard]] const Complaint* complain_unclosed(const Verdict& verdict, const Token& found);
  void complain_stray(const Token& token);
  [[nodiscard]] std::string name_of(const Opening& macro) const;

  struct Arranged {
    Token token = {};
    bool mended = false;
    std::optional<std::uint32_t> closes = {};  ///< place of the bracket that it closes
    bool misplaced = false;                    ///< as Verdict::misplaced
  };

  Lexer& lexer_;
  DiagnosticSink& scanned_;
  const SymbolTable& symbols_;
  Complaints& complaints_;
  std::size_t max_nesting_;
  std::span<const std::uint32_t> parted_;  ///< places of those braces from here on, in the order of the text
  StepCounter steps_;
  Nesting nesting_;
  TokenKind taken_ = Parser::token::TOK_END_OF_FILE;  ///< kind of the last token of the text
  std::deque<Token> ahead_;                           ///< scanned, but not taken yet
  std::deque<Arranged> arranged_;                     ///< ready for the parser
  std::vector<Token> passed_over_;                    ///< misspelt directives, for messages about unmatched ones
  SourceSpan last_span_;                              ///< span of the last token of the text
  std::size_t depth_before_ = 0;                      ///< depth of the nesting before the last token
  Arranged last_;                                     ///< the parser's current token
  std::size_t sent_ = 0;                              ///< number of tokens passed to the parser
  std::size_t wrong_at_ = 0;                          ///< value of sent_ when the parser last rejected a token
  std::size_t wrong_in_turn_ = 0;                     ///< how often the parser rejected the same token again
  std::size_t right_since_ = 0;                       ///< value of sent_ since which all tokens were right
  bool in_doubt_ = false;                             ///< a mistake was met, and no statement has ended since
  bool begins_stretch_ = false;                       ///< the last token shapes a directive
  std::size_t skipping_from_ = 0;                     ///< depth of the bracket whose rest is being skipped; 0 for none
  bool skipped_ = false;                              ///< the rest of the bracket with the last mistake was skipped
  bool too_deep_ = false;
  bool has_unmatched_brace_ = false;
};

}  // namespace isl::grammar
