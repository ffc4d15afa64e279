#include "grammar/token_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <utility>

namespace isl::grammar {
namespace {

using Kind = Parser::token;

/// Enough to see the nesting, few enough to read.
constexpr std::size_t kMaxOpenNotes = 3;

/// The kind of an operator within `function {}`.
TokenKind in_function(TokenKind kind) {
  switch (kind) {
    case Kind::TOK_LESS: return Kind::TOK_FUNCTION_LESS;
    case Kind::TOK_GREATER: return Kind::TOK_FUNCTION_GREATER;
    case Kind::TOK_EQUAL: return Kind::TOK_FUNCTION_EQUAL;
    case Kind::TOK_LESS_EQUAL: return Kind::TOK_FUNCTION_LESS_EQUAL;
    case Kind::TOK_GREATER_EQUAL: return Kind::TOK_FUNCTION_GREATER_EQUAL;
    case Kind::TOK_NOT_EQUAL: return Kind::TOK_FUNCTION_NOT_EQUAL;
    case Kind::TOK_AND: return Kind::TOK_FUNCTION_AND;
    case Kind::TOK_OR: return Kind::TOK_FUNCTION_OR;
    default: return kind;
  }
}

/// A mistake within fewer correct tokens than this may follow from the one before.
constexpr std::size_t kTokensOfDoubt = 3;

/// True for a token that ends a list of items, which the parser is in after any mistake, or the bracket around the
/// mistake.
bool ends_items(TokenKind kind) {
  switch (kind) {
    case Kind::TOK_END_OF_FILE:
    case Kind::TOK_RIGHT_BRACE:
    case Kind::TOK_RIGHT_PARENTHESIS:
    case Kind::TOK_RIGHT_BRACKET: return true;
    default: return shapes_directive(kind) && !opens_directive(kind);
  }
}

/// True if the token can begin an item of a list; a comma and a semicolon are items, too.
bool begins_item(TokenKind kind) {
  switch (kind) {
    case Kind::TOK_UNCLOSED:
    case Kind::TOK_DEPRECATED:
    case Kind::TOK_ONCE:
    case Kind::TOK_DOT:
    case Kind::TOK_QUESTION:
    case Kind::TOK_COLON:
    case Kind::TOK_STAR:
    case Kind::TOK_SLASH:
    case Kind::TOK_AND:
    case Kind::TOK_OR:
    case Kind::TOK_GREATER:
    case Kind::TOK_EQUAL:
    case Kind::TOK_LESS_EQUAL:
    case Kind::TOK_GREATER_EQUAL:
    case Kind::TOK_NOT_EQUAL: return false;
    default: return kind < Kind::TOK_FUNCTION_AND || kind > Kind::TOK_FUNCTION_NOT_EQUAL;
  }
}

DiagnosticNote note_to_close(const Opening& opening) {
  return {opening.span, fmt::format("to close this `{}`", spelling(opening.kind))};
}

DiagnosticNote note_of_misspelt(const Token& directive) {
  return {directive.span, fmt::format("this is not a directive; did you mean `{}`?", spelling(directive.kind))};
}

}  // namespace

TokenStream::TokenStream(Lexer& lexer, DiagnosticSink& scanned, const SymbolTable& symbols, Complaints& complaints,
                         std::size_t max_nesting, std::span<const std::uint32_t> parted, const StopFlag* stop)
    : lexer_(lexer),
      scanned_(scanned),
      symbols_(symbols),
      complaints_(complaints),
      max_nesting_(max_nesting),
      parted_(parted),
      steps_(StepCounter::kUnlimited, stop) {}

// ---- From the text --------------------------------------------------------------------------------------------------

Token TokenStream::scan() {
  if (!steps_.take()) throw ScannerFailure("interrupted");
  Token token = lexer_.next();
  if (scanned_.diagnostics().empty()) return token;
  for (const Diagnostic& diagnostic : scanned_.diagnostics()) {
    if (lexer_.is_cut_off()) {
      complaints_.report_certain(diagnostic);
    } else {
      complaints_.report(diagnostic);
    }
  }
  scanned_ = DiagnosticSink();
  return token;
}

Token TokenStream::next_of_text() {
  if (ahead_.empty()) return scan();
  const Token token = ahead_.front();
  ahead_.pop_front();
  return token;
}

const Token& TokenStream::look_ahead(std::size_t distance) {
  while (ahead_.size() < distance) ahead_.push_back(scan());
  return ahead_[distance - 1];
}

/// Words with this meaning only here: `dictionary {`, `array mixed`, and `local.Name`, where the name is no vector's
/// item.
Token TokenStream::as_newer_word(Token token) {
  if (token.symbol == newer_word::kw_dictionary && look_ahead(1).kind == Kind::TOK_LEFT_BRACE)
    return {.kind = Kind::TOK_DICTIONARY, .span = token.span};
  if (token.symbol == newer_word::kw_mixed && taken_ == Kind::TOK_ARRAY)
    return {.kind = Kind::TOK_MIXED, .span = token.span};
  const bool may_be_scope = token.symbol == word::kw_local || token.symbol == newer_word::kw_global;
  if (may_be_scope && taken_ != Kind::TOK_DOT && look_ahead(1).kind == Kind::TOK_DOT &&
      look_ahead(2).kind == Kind::TOK_IDENTIFIER) {
    token.kind = Kind::TOK_SCOPE;
    token.span = join(token.span, ahead_.front().span);
    ahead_.pop_front();
  }
  return token;
}

Token TokenStream::take() {
  Token token = next_of_text();
  if (!parted_.empty() && token.span.begin == parted_.front()) {
    token.kind = token.kind == Kind::TOK_LEFT_BRACE ? Kind::TOK_BLOCK_BEGIN : Kind::TOK_BLOCK_END;
    parted_ = parted_.subspan(1);
  }
  // `#declare deprecated once Name`: words with this meaning only here.
  const bool may_be_deprecated = taken_ == Kind::TOK_DECLARE || taken_ == Kind::TOK_LOCAL;
  if (may_be_deprecated && token.symbol == word::kw_deprecated)
    token = {.kind = Kind::TOK_DEPRECATED, .span = token.span};
  if (taken_ == Kind::TOK_DEPRECATED && token.symbol == word::kw_once)
    token = {.kind = Kind::TOK_ONCE, .span = token.span};
  if (is_newer_word(token.symbol) || token.symbol == word::kw_local) [[unlikely]]
    token = as_newer_word(token);
  taken_ = token.kind;
  return token;
}

// ---- To the parser --------------------------------------------------------------------------------------------------

Token TokenStream::send() {
  last_ = arranged_.front();
  arranged_.pop_front();
  ++sent_;
  return last_.token;
}

/// Inserts closers for the brackets that are left open. The parser first gets an UNCLOSED, which represents the mistake
/// in the tree.
void TokenStream::close_all(const std::vector<Opening>& openings, const Complaint* complaint) {
  if (openings.empty()) return;
  const SourceSpan place{last_span_.end, last_span_.end};
  arranged_.push_back({{.kind = Kind::TOK_UNCLOSED, .span = place, .complaint = complaint}, true});
  for (const Opening& opening : openings) {
    arranged_.push_back({{.kind = closer_of(opening.kind), .span = place}, true, opening.span.begin});
  }
}

Token TokenStream::next() {
  while (arranged_.empty()) {
    // Not before the parser is done with the directive: its reports about that are about the text before it.
    if (std::exchange(begins_stretch_, false)) complaints_.begin_stretch();
    complaints_.set_outside(nesting_.is_outside());
    if (too_deep_) return finish();
    const Token token = take();
    if (token.kind == Kind::TOK_END_OF_FILE || complaints_.is_full()) return finish();
    if (!is_passed_over(token) && !is_too_deep(token)) follow(token);
    if (!too_deep_) last_span_ = token.span;
  }
  return send();
}

/// Within a directive, whose text may never be executed, a misspelt directive opens, divides and ends nothing: POV-Ray
/// finds the end of skipped text in the same way.
bool TokenStream::is_passed_over(const Token& token) {
  const bool is_structure = token.misspelt && shapes_directive(token.kind);
  if (!is_structure || nesting_.innermost_directive() == nullptr) return false;
  passed_over_.push_back(token);
  return true;
}

/// Within a directive, whose text may never be executed, a bracket that is too many is left out. Elsewhere, and for
/// directives that are too many, the text ends before it.
bool TokenStream::is_too_deep(const Token& token) {
  if (nesting_.depth() < max_nesting_ || !(opens_bracket(token.kind) || opens_directive(token.kind))) return false;
  Diagnostic diagnostic;
  diagnostic.span = token.span;
  diagnostic.message = fmt::format("more than {} brackets and directives are open", max_nesting_);
  if (opens_bracket(token.kind) && nesting_.innermost_directive() != nullptr) {
    complaints_.report(std::move(diagnostic));
  } else {
    complaints_.report_certain(std::move(diagnostic));
    too_deep_ = true;
  }
  return true;
}

void TokenStream::follow(Token token) {
  depth_before_ = nesting_.depth();
  const Verdict verdict = nesting_.follow(token);
  const bool has_open_brace = std::any_of(verdict.unclosed.begin(), verdict.unclosed.end(),
                                          [](const Opening& opening) { return opening.kind == Kind::TOK_LEFT_BRACE; });
  if (has_open_brace || (verdict.stray && token.kind == Kind::TOK_RIGHT_BRACE)) has_unmatched_brace_ = true;
  if (verdict.stray) return complain_stray(token);
  if (!verdict.unclosed.empty()) close_all(verdict.unclosed, complain_unclosed(verdict, token));
  begins_stretch_ = shapes_directive(token.kind);
  if (nesting_.in_function()) token.kind = in_function(token.kind);
  arranged_.push_back({token, false, verdict.closed, verdict.misplaced});
}

Token TokenStream::finish() {
  const bool is_known = complaints_.is_full() || too_deep_;
  const std::vector<Opening> open(nesting_.open().rbegin(), nesting_.open().rend());
  // If skipped text does not end, the cause is the mistake in it.
  const std::size_t skipped = skipping_from_ == 0 ? 0 : open.size() - std::min(open.size(), skipping_from_ - 1);
  const std::span<const Opening> unclosed = std::span(open).subspan(skipped);
  const Complaint* complaint = nullptr;
  if (!unclosed.empty() && !is_known) {
    Diagnostic diagnostic;
    diagnostic.span = {last_span_.end, last_span_.end};
    diagnostic.message = fmt::format("unexpected end of file, expected `{}`", spelling(closer_of(unclosed[0].kind)));
    for (std::size_t i = 0; i < std::min(unclosed.size(), kMaxOpenNotes); ++i) {
      diagnostic.notes.push_back(note_to_close(unclosed[i]));
    }
    if (nesting_.innermost_directive() == nullptr) {
      complaint = complaints_.report(std::move(diagnostic));
    } else {
      if (!passed_over_.empty()) diagnostic.notes.push_back(note_of_misspelt(passed_over_.back()));
      complaints_.report_certain(std::move(diagnostic));
    }
  }
  nesting_.clear();
  close_all(open, complaint);
  const bool mended = is_known || !open.empty();
  arranged_.push_back({{.kind = Kind::TOK_END_OF_FILE, .span = {last_span_.end, last_span_.end}}, mended});
  return send();
}

// ---- After mistakes -------------------------------------------------------------------------------------------------

bool TokenStream::meet_mistake() {
  wrong_in_turn_ = wrong_at_ == sent_ ? wrong_in_turn_ + 1 : 0;
  wrong_at_ = sent_;
  const bool may_follow = in_doubt_ && sent_ - right_since_ < kTokensOfDoubt;
  in_doubt_ = true;
  right_since_ = sent_;
  return may_follow;
}

void TokenStream::skip_mistake() {
  const std::vector<Opening>& open = nesting_.open();
  const bool is_within = depth_before_ > 0 && open.size() >= depth_before_;
  skipped_ = false;
  if (last_.mended || !is_within) return;
  const TokenKind kind = open[depth_before_ - 1].kind;
  if (kind != Kind::TOK_LEFT_PARENTHESIS && kind != Kind::TOK_LEFT_BRACKET) return;
  const std::uint32_t opener = open[depth_before_ - 1].span.begin;
  const Arranged wrong = last_;
  const std::size_t sent = sent_;
  skipping_from_ = depth_before_;
  do {
    static_cast<void>(next());
  } while (last_.closes != opener && last_.token.kind != Kind::TOK_END_OF_FILE);
  skipping_from_ = 0;
  skipped_ = true;
  arranged_.push_front(std::exchange(last_, wrong));
  sent_ = sent;
}

bool TokenStream::drops_wrong() {
  const TokenKind kind = last_.token.kind;
  const bool is_dropped = ends_items(kind) ? last_.misplaced : skipped_ || !begins_item(kind);
  if (is_dropped) ++right_since_;
  return is_dropped;
}

// ---- Complaints -----------------------------------------------------------------------------------------------------

std::string TokenStream::name_of(const Opening& macro) const {
  return macro.name == kNoSymbol ? "" : std::string(symbols_.text(macro.name));
}

const Complaint* TokenStream::complain_unclosed(const Verdict& verdict, const Token& found) {
  if (skipping_from_ > 0)
    return nullptr;  // a mistake within them was reported, and probably caused the missing closers
  const std::vector<Opening>& unclosed = verdict.unclosed;
  Diagnostic diagnostic;
  if (verdict.ended && verdict.ended->kind == Kind::TOK_MACRO && verdict.ended->has_head) {
    diagnostic.span = unclosed[0].span;
    diagnostic.message = fmt::format("the body of macro `{}` does not close this `{}`", name_of(*verdict.ended),
                                     spelling(unclosed[0].kind));
    return complaints_.report(std::move(diagnostic));
  }
  diagnostic.span = found.span;
  diagnostic.message =
      fmt::format("expected `{}` before `{}`", spelling(closer_of(unclosed[0].kind)), spelling(found.kind));
  for (std::size_t i = 0; i < std::min(unclosed.size(), kMaxOpenNotes); ++i) {
    diagnostic.notes.push_back(note_to_close(unclosed[i]));
  }
  return complaints_.report(std::move(diagnostic));
}

void TokenStream::complain_stray(const Token& token) {
  const Opening* const directive = nesting_.innermost_directive();
  Diagnostic diagnostic;
  diagnostic.span = token.span;
  if (directive != nullptr && directive->kind == Kind::TOK_MACRO && directive->has_head) {
    complaints_.error(token.span,
                      fmt::format("the body of macro `{}` does not open the bracket or directive that this `{}` closes",
                                  name_of(*directive), spelling(token.kind)));
    return;
  }
  diagnostic.message = fmt::format("unmatched `{}`", spelling(token.kind));
  if (!nesting_.empty()) {
    const Opening& innermost = nesting_.open().back();
    diagnostic.notes.push_back({innermost.span, fmt::format("this `{}` must end first", spelling(innermost.kind))});
  } else if (shapes_directive(token.kind) && !passed_over_.empty()) {
    diagnostic.notes.push_back(note_of_misspelt(passed_over_.back()));
  }
  complaints_.report(std::move(diagnostic));
}

}  // namespace isl::grammar
