#include "tests/fuzz/mutator.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace isl::test {
namespace {

constexpr std::string_view kWords[] = {
#define ISL_WORD(name, word_class) #name,
#include "grammar/words.def"
#undef ISL_WORD
};

constexpr std::string_view kNumbers[] = {"0",    "1",     "-1",     "2",    "0.5",   "1e-12", "1e12", "-1e12",
                                         "1e30", "1e308", "1e-320", "1000", "65536", "(0/0)", "(1/0)"};

constexpr std::string_view kSigns[] = {
    "{",      "}",      "(",        ")",        "[",        "]",      "<",        ">",        ",",
    ";",      ".",      "+",        "-",        "*",        "/",      "=",        "!",        "&",
    "|",      "?",      ":",        "<=",       ">=",       "!=",     "#end",     "#else",    "#if",
    "#while", "#for",   "#switch",  "#case",    "#range",   "#break", "#macro",   "#declare", "#local",
    "#undef", "#ifdef", "#include", "#default", "#version", "\"",     "\"text\"", "@",        "#"};

constexpr std::string_view kFragments[] = {"{ }",
                                           "{ { } }",
                                           "<1, 2, 3>",
                                           "<0, 0, 0>",
                                           "sphere { 0, 1 }",
                                           "union { }",
                                           "blob { }",
                                           "pigment { rgb 1 }",
                                           "pigment { }",
                                           "texture { }",
                                           "normal { bumps 1 }",
                                           "finish { }",
                                           "function { x }",
                                           "function { { } }",
                                           "scale 0",
                                           "scale 1e-30",
                                           "scale <1, 1e9, 1e-9>",
                                           "rotate 1e30",
                                           "translate 1e30",
                                           "inverse",
                                           "array[2] { 1, 2 }",
                                           "rgb 1",
                                           "x",
                                           "pi"};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The end of the token that begins at `i` with a character that is no space.
std::size_t end_of_token(std::string_view text, std::size_t i) {
  if (text[i] == '"') {
    std::size_t end = i + 1;
    while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
    return std::min(end + 1, text.size());
  }
  const bool is_directive = text[i] == '#' && i + 1 < text.size() && is_word(text[i + 1]);
  if (!is_word(text[i]) && !is_directive) return i + 1;
  std::size_t end = i + 1;
  const bool is_number = std::isdigit(static_cast<unsigned char>(text[i])) != 0;
  while (end < text.size() && (is_word(text[end]) || (is_number && text[end] == '.'))) ++end;
  return end;
}

/// The end of the comment that begins at `i`, or `i` if none does. Comments nest.
std::size_t end_of_comment(std::string_view text, std::size_t i) {
  if (text.substr(i, 2) == "//") return std::min(text.find('\n', i), text.size());
  if (text.substr(i, 2) != "/*") return i;
  int depth = 0;
  while (i < text.size()) {
    const std::string_view pair = text.substr(i, 2);
    if (pair == "/*") ++depth;
    if (pair == "*/") --depth;
    i += pair == "/*" || pair == "*/" ? 2 : 1;
    if (depth == 0) return i;
  }
  return text.size();
}

/// The first character that is not a space.
char begin_of(const std::string& token) {
  const std::size_t i = token.find_first_not_of(" \n");
  return i == std::string::npos ? ' ' : token[i];
}

struct Range {
  std::size_t begin = 0, end = 0;
};

/// The range of `word { … }` around or after token `from`; empty if there is none.
Range block_at(const TokenList& tokens, std::size_t from) {
  std::size_t open = from;
  while (open < tokens.size() && begin_of(tokens[open]) != '{') ++open;
  int depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    const char c = begin_of(tokens[i]);
    depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (depth == 0) return {open == 0 ? 0 : open - 1, i + 1};
  }
  return {};
}

TokenList part_of(const TokenList& tokens, Range range) {
  const auto begin = tokens.begin();
  return {begin + static_cast<std::ptrdiff_t>(range.begin), begin + static_cast<std::ptrdiff_t>(range.end)};
}

}  // namespace

TokenList tokens_of(std::string_view text) {
  TokenList tokens;
  std::string before;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t after_comment = end_of_comment(text, i);
    if (after_comment > i) {
      before += ' ';
      i = after_comment;
    } else if (std::isspace(static_cast<unsigned char>(text[i])) != 0) {
      before += text[i] == '\n' ? '\n' : ' ';
      ++i;
    } else {
      const std::size_t end = end_of_token(text, i);
      tokens.push_back(std::exchange(before, "") + std::string(text.substr(i, end - i)));
      i = end;
    }
  }
  return tokens;
}

/// SplitMix64 (Steele, Lea, Flood 2014): the standard library's distributions differ between machines.
std::uint64_t Mutator::draw() {
  std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30u)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27u)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31u);
}

std::string Mutator::foreign_token() {
  switch (below(4)) {
    case 0: return " " + pick(kWords) + " ";
    case 1: return " " + pick(kNumbers) + " ";
    case 2: return pick(kSigns);
    default: return " " + pick(kFragments) + " ";
  }
}

/// Puts up to 30 tokens of another scene between two of this one.
void Mutator::splice(TokenList& tokens) {
  const TokenList& other = scenes_[below(scenes_.size())];
  if (other.empty()) return;
  const std::size_t first = below(other.size());
  const std::size_t count = std::min(1 + below(30), other.size() - first);
  const auto begin = other.begin() + static_cast<std::ptrdiff_t>(first);
  const TokenList part(begin, begin + static_cast<std::ptrdiff_t>(count));
  tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(below(tokens.size() + 1)), part.begin(), part.end());
}

void Mutator::change(TokenList& tokens) {
  if (tokens.empty()) return tokens.push_back(foreign_token());
  const std::size_t at = below(tokens.size());
  const auto place = tokens.begin() + static_cast<std::ptrdiff_t>(at);
  switch (below(7)) {
    case 0: std::swap(tokens[at], tokens[below(tokens.size())]); break;
    case 1: tokens.erase(place); break;
    case 2: tokens.insert(place, " " + tokens[at]); break;
    case 3: tokens[at] = foreign_token(); break;
    case 4: tokens.insert(place, foreign_token()); break;
    case 5: tokens[at] = std::string(tokens[below(tokens.size())]); break;
    default: splice(tokens);
  }
}

void Mutator::replace_by_its_like(std::string& token) {
  const char c = begin_of(token);
  if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
    token = " " + pick(kNumbers) + " ";
  } else if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
    token = " " + pick(kWords) + " ";
  }
}

void Mutator::change_gently(TokenList& tokens) {
  if (tokens.empty()) return;
  const std::size_t at = below(tokens.size());
  const Range block = block_at(tokens, at);
  const auto begin = tokens.begin() + static_cast<std::ptrdiff_t>(block.begin);
  switch (below(6)) {
    case 0: return replace_by_its_like(tokens[at]);
    case 1: {
      // The token comes from the same scene, because its own names and words are likelier to have a meaning there.
      const std::string& other = tokens[below(tokens.size())];
      const auto is_word_token = [](const std::string& t) { return is_word(begin_of(t)); };
      if (is_word_token(tokens[at]) && is_word_token(other)) tokens[at] = std::string(other);
      return;
    }
    case 2:
      for (std::size_t i = at; i < tokens.size(); ++i) {
        if (std::isdigit(static_cast<unsigned char>(begin_of(tokens[i]))) != 0) return replace_by_its_like(tokens[i]);
      }
      return;
    case 3: tokens.erase(begin, tokens.begin() + static_cast<std::ptrdiff_t>(block.end)); return;
    case 4: {
      const TokenList copy = part_of(tokens, block);
      tokens.insert(begin, copy.begin(), copy.end());
      return;
    }
    default: {
      const TokenList& other = scenes_[below(scenes_.size())];
      if (other.empty()) return;
      const TokenList copy = part_of(other, block_at(other, below(other.size())));
      tokens.insert(begin, copy.begin(), copy.end());
    }
  }
}

std::string Mutator::next() {
  origin_ = below(scenes_.size());
  TokenList tokens = scenes_[origin_];
  const bool is_gentle = below(2) == 0;
  for (std::size_t count = 1 + below(4); count > 0; --count) is_gentle ? change_gently(tokens) : change(tokens);
  std::string text;
  for (const std::string& token : tokens) text += token;
  return text;
}

}  // namespace isl::test
