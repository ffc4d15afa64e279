#include "grammar/nesting.h"

#include "base/check.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace isl::grammar {
namespace {

using Kind = Parser::token;

/// True for the tokens that may stand between `function` and its brace.
bool belongs_to_function_head(TokenKind kind) {
  switch (kind) {
    case Kind::TOK_LEFT_PARENTHESIS:
    case Kind::TOK_RIGHT_PARENTHESIS:
    case Kind::TOK_LEFT_BRACE:
    case Kind::TOK_COMMA:
    case Kind::TOK_IDENTIFIER:
    case Kind::TOK_CONSTANT:
    case Kind::TOK_NUMBER: return true;
    default: return false;
  }
}

}  // namespace

TokenKind closer_of(TokenKind opener) {
  switch (opener) {
    case Kind::TOK_LEFT_BRACE: return Kind::TOK_RIGHT_BRACE;
    case Kind::TOK_LEFT_PARENTHESIS: return Kind::TOK_RIGHT_PARENTHESIS;
    case Kind::TOK_LEFT_BRACKET: return Kind::TOK_RIGHT_BRACKET;
    default: return Kind::TOK_END;
  }
}

std::string_view spelling(TokenKind kind) {
  switch (kind) {
    case Kind::TOK_LEFT_BRACE: return "{";
    case Kind::TOK_RIGHT_BRACE: return "}";
    case Kind::TOK_LEFT_PARENTHESIS: return "(";
    case Kind::TOK_RIGHT_PARENTHESIS: return ")";
    case Kind::TOK_LEFT_BRACKET: return "[";
    case Kind::TOK_RIGHT_BRACKET: return "]";
    case Kind::TOK_IF: return "#if";
    case Kind::TOK_IFDEF: return "#ifdef";
    case Kind::TOK_IFNDEF: return "#ifndef";
    case Kind::TOK_WHILE: return "#while";
    case Kind::TOK_FOR: return "#for";
    case Kind::TOK_SWITCH: return "#switch";
    case Kind::TOK_MACRO: return "#macro";
    case Kind::TOK_ELSE: return "#else";
    case Kind::TOK_ELSEIF: return "#elseif";
    case Kind::TOK_CASE: return "#case";
    case Kind::TOK_RANGE: return "#range";
    case Kind::TOK_END: return "#end";
    default: break;
  }
  ISL_CHECK(false, "token {} takes no part in nesting", static_cast<int>(kind));
}

bool opens_bracket(TokenKind kind) {
  return kind == Kind::TOK_LEFT_BRACE || kind == Kind::TOK_LEFT_PARENTHESIS || kind == Kind::TOK_LEFT_BRACKET;
}

bool opens_directive(TokenKind kind) {
  switch (kind) {
    case Kind::TOK_IF:
    case Kind::TOK_IFDEF:
    case Kind::TOK_IFNDEF:
    case Kind::TOK_WHILE:
    case Kind::TOK_FOR:
    case Kind::TOK_SWITCH:
    case Kind::TOK_MACRO: return true;
    default: return false;
  }
}

bool shapes_directive(TokenKind kind) {
  switch (kind) {
    case Kind::TOK_ELSE:
    case Kind::TOK_ELSEIF:
    case Kind::TOK_CASE:
    case Kind::TOK_RANGE:
    case Kind::TOK_END: return true;
    default: return opens_directive(kind);
  }
}

const Opening* Nesting::innermost_directive() const {
  const auto directive =
      std::find_if(open_.rbegin(), open_.rend(), [](const Opening& opening) { return opens_directive(opening.kind); });
  return directive == open_.rend() ? nullptr : &*directive;
}

void Nesting::push(const Token& token) {
  const bool starts_function = token.kind == Kind::TOK_LEFT_BRACE && std::exchange(function_pending_, false);
  // Blocks within a function (`pattern {}`) follow the ordinary rules again; parentheses and directives do not change
  // them.
  const bool inherits = token.kind != Kind::TOK_LEFT_BRACE && in_function();
  open_.push_back({.kind = token.kind, .span = token.span, .in_function = starts_function || inherits});
}

Verdict Nesting::close_bracket(TokenKind opener) {
  std::size_t above = 0;  // open brackets inside the intended one
  while (above < open_.size()) {
    const TokenKind kind = open_[open_.size() - 1 - above].kind;
    if (opens_directive(kind)) break;
    if (kind != opener) {
      ++above;
      continue;
    }
    Verdict verdict;
    std::copy(open_.rbegin(), open_.rbegin() + static_cast<std::ptrdiff_t>(above),
              std::back_inserter(verdict.unclosed));
    verdict.closed = open_[open_.size() - 1 - above].span.begin;
    open_.resize(open_.size() - above - 1);
    const bool ends_head = opener == Kind::TOK_LEFT_PARENTHESIS && !open_.empty() &&
                           opens_directive(open_.back().kind) && !open_.back().has_head;
    if (ends_head) {
      open_.back().has_head = true;
      ++bodies_;
    }
    return verdict;
  }
  return {.unclosed = {}, .stray = true};
}

namespace {

/// True if the directive can continue with that token.
bool can_divide(TokenKind divider, const Opening& directive) {
  if (divider == Kind::TOK_END) return true;
  if (directive.has_else) return false;
  switch (directive.kind) {
    case Kind::TOK_IF:
    case Kind::TOK_IFDEF:
    case Kind::TOK_IFNDEF: return divider == Kind::TOK_ELSE || divider == Kind::TOK_ELSEIF;
    case Kind::TOK_SWITCH: return divider != Kind::TOK_ELSEIF;
    default: return false;
  }
}

}  // namespace

Verdict Nesting::reach_directive(const Token& token) {
  const auto directive =
      std::find_if(open_.rbegin(), open_.rend(), [](const Opening& opening) { return opens_directive(opening.kind); });
  if (directive == open_.rend()) return {.unclosed = {}, .stray = true};
  const auto brackets = directive - open_.rbegin();
  const bool misplaced = !can_divide(token.kind, *directive);
  if (token.kind == Kind::TOK_ELSE) directive->has_else = true;
  Verdict verdict;
  verdict.misplaced = misplaced;
  std::copy(open_.rbegin(), directive, std::back_inserter(verdict.unclosed));
  open_.resize(open_.size() - static_cast<std::size_t>(brackets));
  if (token.kind == Kind::TOK_END) {
    verdict.ended = open_.back();
    bodies_ -= open_.back().has_head ? 1 : 0;
    open_.pop_back();
  }
  return verdict;
}

Verdict Nesting::follow(const Token& token) {
  Verdict verdict;
  if (!belongs_to_function_head(token.kind)) function_pending_ = token.kind == Kind::TOK_FUNCTION;
  if (opens_bracket(token.kind) || opens_directive(token.kind)) {
    push(token);
  } else {
    switch (token.kind) {
      case Kind::TOK_IDENTIFIER:
        if (previous_ == Kind::TOK_MACRO && !open_.empty()) open_.back().name = token.symbol;
        break;
      case Kind::TOK_RIGHT_BRACE: verdict = close_bracket(Kind::TOK_LEFT_BRACE); break;
      case Kind::TOK_RIGHT_PARENTHESIS: verdict = close_bracket(Kind::TOK_LEFT_PARENTHESIS); break;
      case Kind::TOK_RIGHT_BRACKET: verdict = close_bracket(Kind::TOK_LEFT_BRACKET); break;
      case Kind::TOK_ELSE:
      case Kind::TOK_ELSEIF:
      case Kind::TOK_CASE:
      case Kind::TOK_RANGE:
      case Kind::TOK_END: verdict = reach_directive(token); break;
      default: break;
    }
  }
  previous_ = token.kind;
  return verdict;
}

}  // namespace isl::grammar
