#include "grammar/syntax_messages.h"

#include "grammar/newer_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace isl::grammar {
namespace {

using Kind = Parser::symbol_kind;
using SymbolKind = Parser::symbol_kind_type;

/// Users do not read a longer list.
constexpr std::size_t kMaxExpected = 4;

bool contains(std::span<const SymbolKind> kinds, SymbolKind wanted) {
  return std::find(kinds.begin(), kinds.end(), wanted) != kinds.end();
}

/// The user's term for the token. Kinds that stand for many words have names, the others are quoted.
std::string describe(SymbolKind kind) {
  switch (kind) {
    case Kind::S_IDENTIFIER: return "an identifier";
    case Kind::S_KEYWORD: return "a word";
    case Kind::S_COLOUR_WORD: return "a colour";
    case Kind::S_CONSTANT: return "a constant";
    case Kind::S_NUMBER: return "a number";
    case Kind::S_STRING: return "a string";
    case Kind::S_YYEOF: return "the end of the file";
    case Kind::S_FUNCTION: return "`function`";
    default: break;
  }
  const std::string name = Parser::symbol_name(kind);
  return fmt::format("`{}`", name.substr(0, name.find(" in a function")));
}

std::string describe_found(SymbolKind kind, std::string_view text) {
  switch (kind) {
    case Kind::S_YYEOF: return "end of file";
    case Kind::S_NUMBER: return fmt::format("number {}", text);
    case Kind::S_STRING: return "string";
    case Kind::S_IDENTIFIER: return fmt::format("identifier `{}`", text);
    case Kind::S_KEYWORD:
    case Kind::S_COLOUR_WORD:
    case Kind::S_TEXTURE:
    case Kind::S_FUNCTION_WORD:
    case Kind::S_CONSTANT: return fmt::format("reserved word `{}`", text);
    default: return fmt::format("`{}`", text);
  }
}

bool is_expression_start(SymbolKind kind) {
  switch (kind) {
    case Kind::S_NUMBER:
    case Kind::S_STRING:
    case Kind::S_CONSTANT:
    case Kind::S_IDENTIFIER:
    case Kind::S_FUNCTION_WORD:
    case Kind::S_LEFT_PARENTHESIS:
    case Kind::S_LESS:
    case Kind::S_PLUS:
    case Kind::S_MINUS:
    case Kind::S_NOT: return true;
    default: return false;
  }
}

bool is_object_start(SymbolKind kind) {
  switch (kind) {
    case Kind::S_KEYWORD:
    case Kind::S_COLOUR_WORD:
    case Kind::S_TEXTURE:
    case Kind::S_ARRAY:
    case Kind::S_FUNCTION:
    case Kind::S_LEFT_BRACE:
    case Kind::S_LEFT_BRACKET:
    case Kind::S_UNCLOSED: return true;
    default: return false;
  }
}

bool is_operator(SymbolKind kind) {
  switch (kind) {
    case Kind::S_STAR:
    case Kind::S_SLASH:
    case Kind::S_DOT:
    case Kind::S_PLUS:
    case Kind::S_MINUS:
    case Kind::S_AND:
    case Kind::S_OR:
    case Kind::S_QUESTION:
    case Kind::S_LESS:
    case Kind::S_GREATER:
    case Kind::S_EQUAL:
    case Kind::S_LESS_EQUAL:
    case Kind::S_GREATER_EQUAL:
    case Kind::S_NOT_EQUAL: return true;
    default: return kind >= Kind::S_FUNCTION_AND && kind <= Kind::S_FUNCTION_NOT_EQUAL;
  }
}

/// True for a directive in a list of items; `#else`, `#case` and `#end` belong to the open directive and are named.
bool is_directive_start(SymbolKind kind) {
  switch (kind) {
    case Kind::S_ELSE:
    case Kind::S_ELSEIF:
    case Kind::S_END:
    case Kind::S_CASE:
    case Kind::S_RANGE: return false;
    default: return kind >= Kind::S_DECLARE && kind <= Kind::S_WRITE;
  }
}

/// True if the only thing that may follow is a component after a dot.
bool wants_component(std::span<const SymbolKind> expected) {
  return contains(expected, Kind::S_CONSTANT) && contains(expected, Kind::S_KEYWORD) &&
         !contains(expected, Kind::S_NUMBER);
}

/// The ideas, the most telling first: closing brackets and separators, then kinds of things.
std::vector<std::string> fold(std::span<const SymbolKind> expected) {
  if (wants_component(expected)) return {"a component such as `x` or `red`"};
  const bool has_expression = contains(expected, Kind::S_NUMBER) && contains(expected, Kind::S_LEFT_PARENTHESIS);
  const bool has_object = contains(expected, Kind::S_KEYWORD) && contains(expected, Kind::S_TEXTURE);
  const bool has_operator = contains(expected, Kind::S_STAR);
  const bool has_directive = contains(expected, Kind::S_DECLARE);
  std::vector<std::string> ideas;
  for (const SymbolKind kind : expected) {
    if (has_expression && is_expression_start(kind)) continue;
    if (has_object && is_object_start(kind)) continue;
    if (has_operator && (is_operator(kind) || kind == Kind::S_LEFT_PARENTHESIS || kind == Kind::S_LEFT_BRACKET))
      continue;
    if (has_directive && is_directive_start(kind)) continue;
    if (kind == Kind::S_SEMICOLON && has_directive) continue;
    // rarely known, and hardly ever the intended token
    if (kind == Kind::S_DEPRECATED || kind == Kind::S_ONCE) continue;
    // An operator within `function {}` is a token of its own with the same spelling.
    if (std::string idea = describe(kind); std::ranges::find(ideas, idea) == ideas.end())
      ideas.push_back(std::move(idea));
  }
  if (has_expression) ideas.emplace_back("an expression");
  if (has_object) ideas.emplace_back("an object");
  if (has_operator) ideas.emplace_back("an operator");
  return ideas;
}

std::string list(const std::vector<std::string>& ideas) {
  std::string text = ideas.front();
  for (std::size_t i = 1; i < ideas.size(); ++i) {
    text += i + 1 == ideas.size() ? " or " : ", ";
    text += ideas[i];
  }
  return text;
}

/// Hints for common mistakes.
std::string hint_for(SymbolKind found, std::string_view text, std::span<const SymbolKind> expected) {
  const bool wants_name = contains(expected, Kind::S_IDENTIFIER) && !contains(expected, Kind::S_NUMBER);
  const bool is_reserved_word = found == Kind::S_KEYWORD || found == Kind::S_COLOUR_WORD || found == Kind::S_TEXTURE ||
                                found == Kind::S_FUNCTION_WORD || found == Kind::S_CONSTANT;
  if (wants_name && is_reserved_word) return fmt::format("`{}` is reserved; begin names with a capital letter", text);
  if (contains(expected, Kind::S_LEFT_PARENTHESIS) && expected.size() == 1) return "parentheses are required here";
  const bool compares = found == Kind::S_EQUAL || found == Kind::S_LESS_EQUAL || found == Kind::S_GREATER_EQUAL ||
                        found == Kind::S_NOT_EQUAL || found == Kind::S_GREATER || found == Kind::S_AND ||
                        found == Kind::S_OR || found == Kind::S_QUESTION;
  if (compares && contains(expected, Kind::S_DECLARE)) {
    return found == Kind::S_EQUAL ? "set a variable with `#declare Name = …`, and put comparisons in parentheses"
                                  : "put comparisons, `&`, `|` and `?:` in parentheses";
  }
  return {};
}

/// If nearly any token may follow but the found one may not, the most likely mistake is the missing end of the open
/// bracket: `sin(pi/4;`.
std::string_view missing_bracket(SymbolKind found, std::span<const SymbolKind> expected) {
  const bool ends_statement = found == Kind::S_SEMICOLON || found == Kind::S_RIGHT_BRACE || found == Kind::S_YYEOF;
  return ends_statement && contains(expected, Kind::S_RIGHT_PARENTHESIS) ? ", expected `)`" : "";
}

}  // namespace

SyntaxMessage syntax_message(SymbolKind found, std::string_view text, std::span<const SymbolKind> expected) {
  if (found == Kind::S_IDENTIFIER && is_newer_word(text)) return {newer_word_message(text), {}};
  SyntaxMessage result{.message = "unexpected " + describe_found(found, text), .hint = hint_for(found, text, expected)};
  const std::vector<std::string> ideas = fold(expected);
  if (!ideas.empty() && ideas.size() <= kMaxExpected) {
    result.message += ", expected " + list(ideas);
  } else {
    result.message += missing_bracket(found, expected);
  }
  return result;
}

}  // namespace isl::grammar
