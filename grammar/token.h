// One token, as the scanner makes it, the token stream arranges it and the parser reads it. Its kinds are the parser's.
#pragma once

#include "base/source_span.h"
#include "grammar/complaint.h"
#include "grammar/parser.hh"
#include "grammar/symbols.h"
#include "grammar/text_literal.h"

namespace isl::grammar {

using TokenKind = Parser::token::token_kind_type;

/// Which of the values is live follows from the kind: `symbol` for words and identifiers, `number` for numbers,
/// `literal` for strings, `complaint` for UNCLOSED, what stands where brackets end without their closers.
struct Token {
  TokenKind kind = Parser::token::TOK_END_OF_FILE;
  SourceSpan span = {};
  Symbol symbol = kNoSymbol;
  double number = 0;
  TextLiteral literal = {};
  const Complaint* complaint = nullptr;  ///< null: it was dropped, or is said elsewhere
  bool misspelt = false;                  ///< a directive: the one that is nearest to what stands there
};

}  // namespace isl::grammar
