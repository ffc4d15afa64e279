#include "grammar/scan_state.h"

#include "base/check.h"
#include "grammar/suggest.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <utility>

namespace isl::grammar {
namespace {

using Kind = Parser::token;

struct Directive {
  std::string_view word;
  TokenKind kind;
};

/// A piece of the text for a message: only the beginning of a very long one.
std::string shown(std::string_view text) {
  constexpr std::size_t kShown = 64;
  return text.size() <= kShown ? std::string(text) : std::string(text.substr(0, kShown)) + "…";
}

constexpr auto kDirectives = std::to_array<Directive>({
#define ISL_DIRECTIVE(word, token) {word, Kind::TOK_##token},
#include "grammar/directives.def"
#undef ISL_DIRECTIVE
});

constexpr auto kDirectiveWords = std::to_array<std::string_view>({
#define ISL_DIRECTIVE(word, token) word,
#include "grammar/directives.def"
#undef ISL_DIRECTIVE
});

const Directive* find_directive(std::string_view word) {
  for (const Directive& directive : kDirectives) {
    if (directive.word == word) return &directive;
  }
  return nullptr;
}

TokenKind kind_of(WordClass word_class) {
  switch (word_class) {
    case WordClass::identifier: return Kind::TOK_IDENTIFIER;
    case WordClass::keyword: return Kind::TOK_KEYWORD;
    case WordClass::colour: return Kind::TOK_COLOUR_WORD;
    case WordClass::texture: return Kind::TOK_TEXTURE;
    case WordClass::function: return Kind::TOK_FUNCTION_WORD;
    case WordClass::constant: return Kind::TOK_CONSTANT;
    case WordClass::array: return Kind::TOK_ARRAY;
    case WordClass::function_literal: return Kind::TOK_FUNCTION;
  }
  ISL_CHECK(false, "word class {}", static_cast<int>(word_class));
}

/// Outside strings and comments POV-Ray's language is ASCII; for other characters that editors insert, the hint names
/// the ASCII one.
std::string hint_for(std::string_view character) {
  static constexpr auto kHints = std::to_array<std::pair<std::string_view, std::string_view>>({
      {"%", "write `mod(a, b)` for the remainder of a division"},
      {"^", "write `pow(a, b)` for a power"},
      {"'", "write strings between double quotes"},
      {"\xE2\x80\x98", "write strings between straight double quotes"},
      {"\xE2\x80\x99", "write strings between straight double quotes"},
      {"\xE2\x80\x9C", "write strings between straight double quotes"},
      {"\xE2\x80\x9D", "write strings between straight double quotes"},
      {"\xE2\x80\x93", "write a minus as `-`"},
      {"\xE2\x88\x92", "write a minus as `-`"},
  });
  for (const auto& [found, hint] : kHints) {
    if (found == character) return std::string(hint);
  }
  return {};
}

/// The characters that an escape stands for; empty when it stands for none.
std::string resolve_escape(std::string_view escape) {
  if (escape.size() < 2) return {};
  switch (escape[1]) {
    case 'a': return "\a";
    case 'b': return "\b";
    case 'f': return "\f";
    case 'n': return "\n";
    case 'r': return "\r";
    case 't': return "\t";
    case 'v': return "\v";
    case '0': return std::string(1, '\0');
    case '"':
    case '\'':
    case '\\': return std::string(escape.substr(1));
    case 'u': break;
    default: return {};
  }
  if (escape.size() < 6) return {};
  unsigned code = 0;
  std::from_chars(escape.data() + 2, escape.data() + 6, code, 16);
  const auto byte = [](unsigned value) { return static_cast<char>(static_cast<unsigned char>(value)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | (code >> 6)), byte(0x80 | (code & 0x3F))};
  return {byte(0xE0 | (code >> 12)), byte(0x80 | ((code >> 6) & 0x3F)), byte(0x80 | (code & 0x3F))};
}

}  // namespace

ScanState::ScanState(std::string_view text, std::uint32_t begin, SymbolTable& symbols, Arena& arena,
                     DiagnosticSink& sink)
    : text_(text), file_begin_(begin), begin_(begin), end_(begin), symbols_(symbols), arena_(arena), sink_(sink) {}

void ScanState::advance(std::size_t bytes) {
  begin_ = end_;
  end_ += static_cast<std::uint32_t>(bytes);
}

std::string_view ScanState::text_between(std::uint32_t begin, std::uint32_t end) const {
  return text_.substr(begin - file_begin_, end - begin);
}

void ScanState::complain(SourceSpan span, std::string message, std::string hint) {
  if (!sink_.is_full()) sink_.error(span, std::move(message), std::move(hint));
}

Token ScanState::word(std::string_view text) {
  const Symbol symbol = symbols_.intern(text);
  // POV-Ray 1 and 2 had these without `#`; their scenes are still in use.
  if (symbol == word::kw_declare || symbol == word::kw_include) {
    sink_.warning(span(), fmt::format("`{0}` without `#` is an old form; it is read as `#{0}`", text));
    return simple(find_directive(text)->kind);
  }
  return {.kind = kind_of(symbols_.word_class(symbol)), .span = span(), .symbol = symbol};
}

Token ScanState::number(std::string_view text) {
  Token token{.kind = Kind::TOK_NUMBER, .span = span()};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), token.number);
  if (result.ec != std::errc::result_out_of_range) return token;
  token.number = std::strtod(std::string(text).c_str(), nullptr);  // from_chars does not tell overflow from underflow
  if (token.number > 1) complain(span(), fmt::format("the number {} is too large", shown(text)));
  return token;
}

std::optional<Token> ScanState::directive(std::string_view text) {
  const std::string_view word = text.substr(text.find_first_not_of(std::string_view("# \t\r\n\f\v\0\x1A", 9)));
  if (const Directive* const found = find_directive(word)) return simple(found->kind);
  const std::string_view after = text_.substr(end_ - file_begin_);
  const std::size_t next = after.find_first_not_of(" \t\r\n");
  const char follower = next == std::string_view::npos ? '\0' : after[next];
  // POV-Ray ignores the `#` before any other word; scenes that it reads contain `#union {`.
  if (follower == '{' && is_reserved(symbols_.intern(word))) {
    sink_.warning(span(), fmt::format("`#{0}` is not a directive; it is read as `{0}`", word));
    return this->word(word);
  }
  if (const auto near = closest(word, kDirectiveWords)) {
    complain(span(), fmt::format("unknown directive `#{}`", shown(word)), fmt::format("did you mean `#{}`?", *near));
    Token token = simple(find_directive(*near)->kind);
    token.misspelt = true;
    return token;
  }
  if (follower == '(') return this->word(word);
  complain(span(), fmt::format("unknown directive `#{}`", shown(word)));
  return std::nullopt;
}

Token ScanState::foreign(TokenKind meant, std::string_view written, std::string_view right) {
  complain(span(), fmt::format("unexpected `{}`", written), fmt::format("write `{}`", right));
  return simple(meant);
}

void ScanState::bad_character(std::string_view text) {
  const auto byte = static_cast<unsigned char>(text[0]);
  const bool printable = text.size() > 1 || (byte > 0x20 && byte < 0x7F);
  complain(span(),
           printable ? fmt::format("unexpected character `{}`", text) : fmt::format("unexpected byte 0x{:02X}", byte),
           hint_for(text));
}

void ScanState::stray_comment_end() { complain(span(), "unmatched `*/`: no comment is open"); }

void ScanState::lone_hash() { sink_.warning(span(), "`#` without the name of a directive is ignored"); }

bool ScanState::close_comment() {
  comment_openings_.pop_back();
  return comment_openings_.empty();
}

void ScanState::unclosed_comment() {
  is_cut_off_ = true;
  complain(comment_openings_.front(), "this comment is not closed", "comments nest: each `/*` needs its own `*/`");
  comment_openings_.clear();
}

void ScanState::open_string() {
  string_begin_ = begin_;
  copied_until_ = end_;
  string_text_.clear();
  string_differs_ = false;
}

void ScanState::copy_string_until(std::uint32_t place) { string_text_.append(text_between(copied_until_, place)); }

void ScanState::replace_in_string(std::string_view characters) {
  copy_string_until(begin_);
  string_text_.append(characters);
  copied_until_ = end_;
  string_differs_ = true;
}

void ScanState::line_end_in_string(std::string_view text) {
  if (text != "\n") replace_in_string("\n");
}

void ScanState::escape(std::string_view text) {
  const std::string resolved = resolve_escape(text);
  if (!resolved.empty()) return replace_in_string(resolved);
  // File names take backslashes literally and the scanner cannot tell which strings are file names: hence no error.
  sink_.warning(span(), fmt::format("`{}` is not an escape sequence; the backslash is kept", text),
                "write a backslash as `\\\\`, and separate folders in file names by `/`");
}

Token ScanState::close_string() {
  // POV-Ray reads such strings, but nearly always a quote is missing, and the mistake shows where the next string
  // begins.
  const std::string_view lines = text_between(string_begin_, end_);
  if (!is_cut_off_ && lines.find_first_of("\r\n") != std::string_view::npos)
    sink_.warning({string_begin_, string_begin_ + 1}, "this string extends over several lines",
                  "if that is not intended, add a `\"` at the end of this line");
  Token token{.kind = Kind::TOK_STRING, .span = {string_begin_, end_}};
  const std::uint32_t text_end = begin_;
  token.literal.raw = text_between(string_begin_ + 1, text_end);
  token.literal.text = token.literal.raw;
  if (string_differs_) {
    copy_string_until(text_end);
    token.literal.text = arena_.copy_text(string_text_);
  }
  return token;
}

Token ScanState::unclosed_string() {
  is_cut_off_ = true;
  complain({string_begin_, string_begin_ + 1}, "this string is not closed");
  begin_ = end_;
  return close_string();
}

Token ScanState::end_of_file() const { return {.kind = Kind::TOK_END_OF_FILE, .span = {end_, end_}}; }

}  // namespace isl::grammar
