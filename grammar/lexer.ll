/* The regular expressions of the tokens. scan_state.cpp makes tokens of the matches; token_stream.cpp checks nesting.

   Every start condition has a catch-all rule: flex's default rule and its fatal errors would print or end the process.
   No rule uses `/` with two parts of variable length: such a scanner cannot match more than 16 KiB at once. */
%option reentrant noyywrap nounput noinput nodefault never-interactive 8bit stack warn
%option noyy_top_state
%option prefix="isl_scanner_" extra-type="isl::grammar::ScanState*"

%top{
#include "grammar/lexer.h"
#include "grammar/scan_state.h"

#include <cstddef>
#include <optional>
#include <string_view>
}

%{
#define YY_DECL isl::grammar::Token isl_scanner_lex(yyscan_t yyscanner)
YY_DECL;
#define YY_USER_ACTION yyextra->advance(static_cast<std::size_t>(yyleng));
#define YY_FATAL_ERROR(message) throw isl::grammar::ScannerFailure(message)
#define yyterminate() return yyextra->end_of_file()

namespace {
using Kind = isl::grammar::Parser::token;
}
%}

WORD       [A-Za-z_][A-Za-z0-9_]*
NUMBER     ([0-9]+"."?[0-9]*|"."[0-9]+)([eE][+-]?[0-9]+)?
BLANK      [ \t\f\v\0\x1A]
LINE_END   \n|\r|\r\n|\n\r
CHARACTER  [\xC2-\xDF][\x80-\xBF]|[\xE0-\xEF][\x80-\xBF]{2}|[\xF0-\xF4][\x80-\xBF]{3}|[\x00-\xFF]

%x COMMENT STRING

%%
%{
  const auto text = [&] { return std::string_view(yytext, static_cast<std::size_t>(yyleng)); };
%}

({BLANK}|[\r\n])+      { }
"\xEF\xBB\xBF"         { /* the byte order mark of UTF-8 */ }
"//"[^\r\n]*           { }
"*/"                   { yyextra->stray_comment_end(); }

"/*"                   { yyextra->open_comment(); yy_push_state(COMMENT, yyscanner); }
<COMMENT>{
  "/*"                 { yyextra->open_comment(); }
  "*/"                 { if (yyextra->close_comment()) yy_pop_state(yyscanner); }
  [^*/]+|[*/]          { }
  <<EOF>>              { yyextra->unclosed_comment(); yy_pop_state(yyscanner); yyterminate(); }
}

"\""                   { yyextra->open_string(); yy_push_state(STRING, yyscanner); }
<STRING>{
  "\""                 { yy_pop_state(yyscanner); return yyextra->close_string(); }
  "\\u"[0-9A-Fa-f]{4}  { yyextra->escape(text()); }
  "\\"[^\r\n]?         { yyextra->escape(text()); }
  {LINE_END}           { yyextra->line_end_in_string(text()); }
  [\0\x1A]             { yyextra->replace_in_string({}); }
  [^"\\\r\n\0\x1A]+    { }
  <<EOF>>              { yy_pop_state(yyscanner); return yyextra->unclosed_string(); }
}

"#"({BLANK}|[\r\n])*{WORD} { if (const auto token = yyextra->directive(text())) return *token; }
{WORD}                 { return yyextra->word(text()); }
{NUMBER}               { return yyextra->number(text()); }

"<="                   { return yyextra->simple(Kind::TOK_LESS_EQUAL); }
">="                   { return yyextra->simple(Kind::TOK_GREATER_EQUAL); }
"!="                   { return yyextra->simple(Kind::TOK_NOT_EQUAL); }
"=="                   { return yyextra->foreign(Kind::TOK_EQUAL, text(), "="); }
"&&"                   { return yyextra->foreign(Kind::TOK_AND, text(), "&"); }
"||"                   { return yyextra->foreign(Kind::TOK_OR, text(), "|"); }
"+"                    { return yyextra->simple(Kind::TOK_PLUS); }
"-"                    { return yyextra->simple(Kind::TOK_MINUS); }
"*"                    { return yyextra->simple(Kind::TOK_STAR); }
"/"                    { return yyextra->simple(Kind::TOK_SLASH); }
"<"                    { return yyextra->simple(Kind::TOK_LESS); }
">"                    { return yyextra->simple(Kind::TOK_GREATER); }
"="                    { return yyextra->simple(Kind::TOK_EQUAL); }
"&"                    { return yyextra->simple(Kind::TOK_AND); }
"|"                    { return yyextra->simple(Kind::TOK_OR); }
"!"                    { return yyextra->simple(Kind::TOK_NOT); }
"?"                    { return yyextra->simple(Kind::TOK_QUESTION); }
":"                    { return yyextra->simple(Kind::TOK_COLON); }
","                    { return yyextra->simple(Kind::TOK_COMMA); }
";"                    { return yyextra->simple(Kind::TOK_SEMICOLON); }
"."                    { return yyextra->simple(Kind::TOK_DOT); }
"("                    { return yyextra->simple(Kind::TOK_LEFT_PARENTHESIS); }
")"                    { return yyextra->simple(Kind::TOK_RIGHT_PARENTHESIS); }
"["                    { return yyextra->simple(Kind::TOK_LEFT_BRACKET); }
"]"                    { return yyextra->simple(Kind::TOK_RIGHT_BRACKET); }
"{"                    { return yyextra->simple(Kind::TOK_LEFT_BRACE); }
"}"                    { return yyextra->simple(Kind::TOK_RIGHT_BRACE); }

"#"                    { yyextra->lone_hash(); }
{CHARACTER}            { yyextra->bad_character(text()); }
<<EOF>>                { yyterminate(); }

%%

namespace isl::grammar {

void CloseScanner::operator()(void* scanner) const { isl_scanner_lex_destroy(scanner); }

Lexer::Lexer(std::string_view text, std::uint32_t begin, SymbolTable& symbols, Arena& arena, DiagnosticSink& sink)
    : state_(text, begin, symbols, arena, sink) {
  if (text.size() > kMaxTextBytes) throw ScannerFailure("the text is too long");
  void* scanner = nullptr;
  if (isl_scanner_lex_init_extra(&state_, &scanner) != 0) throw ScannerFailure("out of memory");
  scanner_.reset(scanner);
  isl_scanner__scan_bytes(text.data(), static_cast<int>(text.size()), scanner);
}

Token Lexer::next() { return isl_scanner_lex(scanner_.get()); }

}  // namespace isl::grammar
