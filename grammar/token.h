// One token: the scanner makes it, the token stream arranges it and the parser reads it. Its kinds are the parser's.
#pragma once

#include "base/source_span.h"
#include "grammar/complaint.h"
#include "grammar/parser.hh"
#include "grammar/symbols.h"
#include "grammar/text_literal.h"

namespace isl::grammar {

using TokenKind = Parser::token::token_kind_type;

/// The kind decides which value is live: `symbol` for words and identifiers, `number` for numbers, `literal` for
/// strings, `complaint` for UNCLOSED, which represents the place where brackets end without their closers.
struct Token {
  TokenKind kind = Parser::token::TOK_END_OF_FILE;
  SourceSpan span = {};
  Symbol symbol = kNoSymbol;
  double number = 0;
  TextLiteral literal = {};
  const Complaint* complaint = nullptr;  ///< null: it was dropped, or is reported elsewhere
  bool misspelt = false;                 ///< for a directive: `symbol` is the nearest one to the text
};

}  // namespace isl::grammar
