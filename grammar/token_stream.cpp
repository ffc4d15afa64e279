#include "grammar/token_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace isl::grammar {
namespace {

using Kind = Parser::token;

/// Enough to see the way in, few enough to read.
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

DiagnosticNote note_to_close(const Opening& opening) {
  return {opening.span, fmt::format("to close this `{}`", spelling(opening.kind))};
}

}  // namespace

TokenStream::TokenStream(Lexer& lexer, const SymbolTable& symbols, Arena& arena, DiagnosticSink& sink,
                         std::size_t max_nesting)
    : lexer_(lexer), symbols_(symbols), arena_(arena), sink_(sink), max_nesting_(max_nesting) {}

// ---- From the text --------------------------------------------------------------------------------------------------

Token TokenStream::take() {
  if (ahead_.empty()) return lexer_.next();
  const Token token = ahead_.front();
  ahead_.pop_front();
  return token;
}

Token TokenStream::take_from_text() {
  const bool is_new = ahead_.empty();
  const Token token = take();
  if (token.kind == Kind::TOK_DECLARE || token.kind == Kind::TOK_LOCAL) skip_deprecation();
  if (token.kind == Kind::TOK_MACRO && is_new) read_macro();
  return token;
}

/// `#declare deprecated once "use that" Name = …`: what follows is declared, the remark is dropped.
void TokenStream::skip_deprecation() {
  Token token = take();
  if (token.symbol == word::kw_deprecated) {
    token = take();
    if (token.symbol == word::kw_once) token = take();
    if (token.kind == Kind::TOK_STRING) token = take();
  }
  ahead_.push_front(token);
}

void TokenStream::read_macro() {
  std::size_t open_directives = 1;
  while (open_directives > 0) {
    const Token& token = ahead_.emplace_back(lexer_.next());
    if (token.kind == Kind::TOK_END_OF_FILE) return;  // the missing `#end` is reported when the end is reached
    if (opens_directive(token.kind)) ++open_directives;
    if (token.kind == Kind::TOK_END) --open_directives;
  }
  set_aside_unbalanced_body();
}

void TokenStream::set_aside_unbalanced_body() {
  const auto closes_parameters = [](const Token& token) { return token.kind == Kind::TOK_RIGHT_PARENTHESIS; };
  const auto body = std::find_if(ahead_.begin(), ahead_.end(), closes_parameters);
  if (body == ahead_.end()) return;
  const auto begin = static_cast<std::size_t>(body - ahead_.begin()) + 1;
  const std::optional<Token> trouble = check_body(begin);
  if (!trouble) return;
  const Token end = ahead_.back();
  ahead_.resize(begin);
  ahead_.push_back(*trouble);
  ahead_.push_back(end);
}

/// The token that stands for a body whose brackets do not match; none for one whose brackets do.
std::optional<Token> TokenStream::check_body(std::size_t begin) const {
  const std::string_view name = ahead_.front().symbol == kNoSymbol ? "" : symbols_.text(ahead_.front().symbol);
  const auto trouble = [&](SourceSpan span, std::string_view what, TokenKind kind) {
    const std::string message = fmt::format("the body of macro `{}` {} this `{}`", name, what, spelling(kind));
    return Token{.kind = Kind::TOK_UNPARSED, .span = span, .literal = {arena_.copy_text(message), {}}};
  };
  Nesting nesting;
  for (std::size_t i = begin; i + 1 < ahead_.size(); ++i) {
    const Verdict verdict = nesting.follow(ahead_[i]);
    if (verdict.stray) return trouble(ahead_[i].span, "does not open what it closes with", ahead_[i].kind);
    if (!verdict.unclosed.empty()) return trouble(verdict.unclosed[0].span, "does not close", verdict.unclosed[0].kind);
  }
  if (nesting.empty()) return std::nullopt;
  return trouble(nesting.open().back().span, "does not close", nesting.open().back().kind);
}

// ---- To the parser --------------------------------------------------------------------------------------------------

Token TokenStream::send() {
  const Arranged first = arranged_.front();
  arranged_.pop_front();
  mending_ = first.mended;
  return first.token;
}

void TokenStream::close_all(const std::vector<Opening>& openings) {
  const SourceSpan place{last_span_.end, last_span_.end};
  for (const Opening& opening : openings) {
    arranged_.push_back({{.kind = closer_of(opening.kind), .span = place}, true});
  }
}

Token TokenStream::next() {
  while (arranged_.empty()) {
    if (too_deep_) return finish();
    Token token = take_from_text();
    if (token.kind == Kind::TOK_END_OF_FILE || sink_.is_full()) return finish();
    depth_before_ = nesting_.depth();
    const Verdict verdict = nesting_.follow(token);
    if (nesting_.depth() > max_nesting_) {
      sink_.error(token.span, fmt::format("more than {} brackets and directives are open", max_nesting_));
      too_deep_ = true;
      continue;
    }
    if (verdict.stray) {
      report_stray(token);
    } else {
      if (!verdict.unclosed.empty()) report_unclosed(verdict.unclosed, token);
      close_all(verdict.unclosed);
      if (nesting_.in_function()) token.kind = in_function(token.kind);
      arranged_.push_back({token, false});
    }
    last_span_ = token.span;
  }
  return send();
}

Token TokenStream::finish() {
  const bool is_known = sink_.is_full() || too_deep_;
  std::vector<Opening> open(nesting_.open().rbegin(), nesting_.open().rend());
  if (!open.empty() && !is_known) {
    Diagnostic diagnostic;
    diagnostic.span = {last_span_.end, last_span_.end};
    diagnostic.message = fmt::format("unexpected end of file, expected `{}`", spelling(closer_of(open[0].kind)));
    for (std::size_t i = 0; i < std::min(open.size(), kMaxOpenNotes); ++i) {
      diagnostic.notes.push_back(note_to_close(open[i]));
    }
    sink_.report(std::move(diagnostic));
  }
  if (too_deep_ && !open.empty()) open.erase(open.begin());  // the parser has not seen the one that was too many
  nesting_.clear();
  close_all(open);
  const bool mended = is_known || !open.empty();
  arranged_.push_back({{.kind = Kind::TOK_END_OF_FILE, .span = {last_span_.end, last_span_.end}}, mended});
  return send();
}

void TokenStream::skip_mistake() {
  const std::vector<Opening>& open = nesting_.open();
  const bool is_within = depth_before_ > 0 && open.size() >= depth_before_;
  if (mending_ || !is_within) return;
  const TokenKind kind = open[depth_before_ - 1].kind;
  if (kind != Kind::TOK_LEFT_PARENTHESIS && kind != Kind::TOK_LEFT_BRACKET) return;
  const std::size_t depth = depth_before_;
  skipping_ = true;
  Arranged closing;
  do {
    closing.token = next();
    closing.mended = mending_;
  } while (nesting_.depth() >= depth);
  skipping_ = false;
  arranged_.push_front(closing);
}

void TokenStream::report_unclosed(const std::vector<Opening>& unclosed, const Token& found) {
  if (skipping_) return;  // a mistake within them was reported; that they are not closed either is of the same making
  Diagnostic diagnostic;
  diagnostic.span = found.span;
  diagnostic.message =
      fmt::format("expected `{}` before `{}`", spelling(closer_of(unclosed[0].kind)), spelling(found.kind));
  for (std::size_t i = 0; i < std::min(unclosed.size(), kMaxOpenNotes); ++i) {
    diagnostic.notes.push_back(note_to_close(unclosed[i]));
  }
  sink_.report(std::move(diagnostic));
}

void TokenStream::report_stray(const Token& token) {
  Diagnostic diagnostic;
  diagnostic.span = token.span;
  diagnostic.message = fmt::format("unexpected `{}`: nothing that it closes is open", spelling(token.kind));
  if (!nesting_.empty()) {
    const Opening& innermost = nesting_.open().back();
    diagnostic.notes.push_back({innermost.span, fmt::format("this `{}` must end first", spelling(innermost.kind))});
  }
  sink_.report(std::move(diagnostic));
}

}  // namespace isl::grammar
