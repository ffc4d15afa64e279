#include "grammar/data_file.h"

#include <fmt/format.h>

namespace isl::grammar {
namespace {

using Kind = Parser::token;

Datum mistake(SourceSpan span, std::string text) {
  return {.kind = Datum::Kind::mistake, .span = span, .count = 0, .terms = {}, .text = std::move(text)};
}

}  // namespace

bool DataFile::read_number(Token& token, double& number) {
  const bool is_negative = token.kind == Kind::TOK_MINUS;
  if (is_negative || token.kind == Kind::TOK_PLUS) token = lexer_.next();
  number = is_negative ? -token.number : token.number;
  return token.kind == Kind::TOK_NUMBER;
}

Datum DataFile::vector(const Token& opening) {
  Datum datum{.kind = Datum::Kind::vector, .span = opening.span, .count = 0, .terms = {}, .text = {}};
  while (true) {
    Token token = lexer_.next();
    if (token.kind == Kind::TOK_COMMA && datum.count > 0) token = lexer_.next();
    datum.span = join(datum.span, token.span);
    if (token.kind == Kind::TOK_GREATER && datum.count >= 2) return datum;
    double number = 0;
    if (!read_number(token, number))
      return mistake(token.span, "expected a number or `>` of a vector of 2 to 5 numbers");
    if (datum.count == static_cast<int>(datum.terms.size())) {
      return mistake(token.span, "expected `>`: a vector has at most 5 numbers");
    }
    datum.terms[datum.count++] = number;
  }
}

Datum DataFile::value(const Token& first) {
  Token token = first;
  Datum datum{.kind = Datum::Kind::number, .span = token.span, .count = 1, .terms = {}, .text = {}};
  if (token.kind == Kind::TOK_LESS) return vector(token);
  if (token.kind == Kind::TOK_STRING) {
    datum.kind = Datum::Kind::string;
    datum.text = token.literal.text;
    return datum;
  }
  if (!read_number(token, datum.terms[0]))
    return mistake(token.span, "expected a number, a vector or a string in quotes");
  datum.span = join(datum.span, token.span);
  return datum;
}

Datum DataFile::next() {
  const Token first = lexer_.next();
  if (first.kind == Kind::TOK_END_OF_FILE) {
    at_end_ = true;
    return {};
  }
  Datum datum = value(first);
  if (datum.kind == Datum::Kind::mistake) return datum;
  const Token separator = lexer_.next();
  at_end_ = separator.kind == Kind::TOK_END_OF_FILE;
  if (!at_end_ && separator.kind != Kind::TOK_COMMA && separator.kind != Kind::TOK_SEMICOLON) {
    return mistake(separator.span, "expected `,` between the values of a file");
  }
  return datum;
}

}  // namespace isl::grammar
