#include "grammar/syntax_messages.h"

#include "grammar/newer_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace isl::grammar {
namespace {

using Symbols = Parser::symbol_kind;
using SymbolKind = Parser::symbol_kind_type;

/// Users do not read a longer list.
constexpr std::size_t kMaxExpected = 4;

bool contains(std::span<const SymbolKind> kinds, SymbolKind wanted) {
  return std::find(kinds.begin(), kinds.end(), wanted) != kinds.end();
}

/// The user's term for the token. Kinds that stand for many words have names, the others are quoted.
std::string describe(SymbolKind kind) {
  switch (kind) {
    case Symbols::S_IDENTIFIER: return "an identifier";
    case Symbols::S_KEYWORD: return "a word";
    case Symbols::S_COLOUR_WORD: return "a colour";
    case Symbols::S_CONSTANT: return "a constant";
    case Symbols::S_NUMBER: return "a number";
    case Symbols::S_STRING: return "a string";
    case Symbols::S_YYEOF: return "the end of the file";
    case Symbols::S_FUNCTION: return "`function`";
    case Symbols::S_SCOPE: return "`local.` or `global.`";
    default: break;
  }
  const std::string name = Parser::symbol_name(kind);
  return fmt::format("`{}`", name.substr(0, name.find(" in a function")));
}

std::string describe_found(SymbolKind kind, std::string_view text) {
  switch (kind) {
    case Symbols::S_YYEOF: return "end of file";
    case Symbols::S_NUMBER: return fmt::format("number {}", text);
    case Symbols::S_STRING: return "string";
    case Symbols::S_IDENTIFIER: return fmt::format("identifier `{}`", text);
    case Symbols::S_KEYWORD:
    case Symbols::S_COLOUR_WORD:
    case Symbols::S_TEXTURE:
    case Symbols::S_FUNCTION_WORD:
    case Symbols::S_CONSTANT: return fmt::format("reserved word `{}`", text);
    default: return fmt::format("`{}`", text);
  }
}

bool is_expression_start(SymbolKind kind) {
  switch (kind) {
    case Symbols::S_NUMBER:
    case Symbols::S_STRING:
    case Symbols::S_CONSTANT:
    case Symbols::S_IDENTIFIER:
    case Symbols::S_SCOPE:
    case Symbols::S_FUNCTION_WORD:
    case Symbols::S_LEFT_PARENTHESIS:
    case Symbols::S_LESS:
    case Symbols::S_PLUS:
    case Symbols::S_MINUS:
    case Symbols::S_NOT: return true;
    default: return false;
  }
}

bool is_object_start(SymbolKind kind) {
  switch (kind) {
    case Symbols::S_KEYWORD:
    case Symbols::S_COLOUR_WORD:
    case Symbols::S_TEXTURE:
    case Symbols::S_ARRAY:
    case Symbols::S_FUNCTION:
    case Symbols::S_DICTIONARY:
    case Symbols::S_LEFT_BRACE:
    case Symbols::S_LEFT_BRACKET:
    case Symbols::S_UNCLOSED: return true;
    default: return false;
  }
}

bool is_operator(SymbolKind kind) {
  switch (kind) {
    case Symbols::S_STAR:
    case Symbols::S_SLASH:
    case Symbols::S_DOT:
    case Symbols::S_PLUS:
    case Symbols::S_MINUS:
    case Symbols::S_AND:
    case Symbols::S_OR:
    case Symbols::S_QUESTION:
    case Symbols::S_LESS:
    case Symbols::S_GREATER:
    case Symbols::S_EQUAL:
    case Symbols::S_LESS_EQUAL:
    case Symbols::S_GREATER_EQUAL:
    case Symbols::S_NOT_EQUAL: return true;
    default: return kind >= Symbols::S_FUNCTION_AND && kind <= Symbols::S_FUNCTION_NOT_EQUAL;
  }
}

/// True for a directive in a list of items; `#else`, `#case` and `#end` belong to the open directive and are named.
bool is_directive_start(SymbolKind kind) {
  switch (kind) {
    case Symbols::S_ELSE:
    case Symbols::S_ELSEIF:
    case Symbols::S_END:
    case Symbols::S_CASE:
    case Symbols::S_RANGE: return false;
    default: return kind >= Symbols::S_DECLARE && kind <= Symbols::S_WRITE;
  }
}

/// True if the only thing that may follow is a component after a dot.
bool wants_component(std::span<const SymbolKind> expected) {
  return contains(expected, Symbols::S_CONSTANT) && contains(expected, Symbols::S_KEYWORD) &&
         !contains(expected, Symbols::S_NUMBER);
}

/// The ideas, the most telling first: closing brackets and separators, then kinds of things.
std::vector<std::string> fold(std::span<const SymbolKind> expected) {
  if (wants_component(expected)) return {"a component such as `x` or `red`"};
  const bool has_expression = contains(expected, Symbols::S_NUMBER) && contains(expected, Symbols::S_LEFT_PARENTHESIS);
  const bool has_object = contains(expected, Symbols::S_KEYWORD) && contains(expected, Symbols::S_TEXTURE);
  const bool has_operator = contains(expected, Symbols::S_STAR);
  const bool has_directive = contains(expected, Symbols::S_DECLARE);
  std::vector<std::string> ideas;
  for (const SymbolKind kind : expected) {
    if (has_expression && is_expression_start(kind)) continue;
    if (has_object && is_object_start(kind)) continue;
    if (has_operator && (is_operator(kind) || kind == Symbols::S_LEFT_PARENTHESIS || kind == Symbols::S_LEFT_BRACKET))
      continue;
    if (has_directive && is_directive_start(kind)) continue;
    if (kind == Symbols::S_SEMICOLON && has_directive) continue;
    // rarely known, and hardly ever the intended token
    if (kind == Symbols::S_DEPRECATED || kind == Symbols::S_ONCE || kind == Symbols::S_MIXED) continue;
    // begins an item only in a dictionary
    if (kind == Symbols::S_DOT && has_expression && !has_operator) continue;
    // goes with identifiers
    if (kind == Symbols::S_SCOPE && contains(expected, Symbols::S_IDENTIFIER)) continue;
    // spelt like the braces that are told anyway
    if (kind == Symbols::S_BLOCK_BEGIN || kind == Symbols::S_BLOCK_END) continue;
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
  const bool wants_name = contains(expected, Symbols::S_IDENTIFIER) && !contains(expected, Symbols::S_NUMBER);
  const bool is_reserved_word = found == Symbols::S_KEYWORD || found == Symbols::S_COLOUR_WORD ||
                                found == Symbols::S_TEXTURE || found == Symbols::S_FUNCTION_WORD ||
                                found == Symbols::S_CONSTANT;
  if (wants_name && is_reserved_word) return fmt::format("`{}` is reserved; begin names with a capital letter", text);
  if (contains(expected, Symbols::S_LEFT_PARENTHESIS) && expected.size() == 1) return "parentheses are required here";
  const bool compares = found == Symbols::S_EQUAL || found == Symbols::S_LESS_EQUAL ||
                        found == Symbols::S_GREATER_EQUAL || found == Symbols::S_NOT_EQUAL ||
                        found == Symbols::S_GREATER || found == Symbols::S_AND || found == Symbols::S_OR ||
                        found == Symbols::S_QUESTION;
  if (compares && contains(expected, Symbols::S_DECLARE)) {
    return found == Symbols::S_EQUAL ? "set a variable with `#declare Name = …`, and put comparisons in parentheses"
                                     : "put comparisons, `&`, `|` and `?:` in parentheses";
  }
  return {};
}

/// If nearly any token may follow but the found one may not, the most likely mistake is the missing end of the open
/// bracket: `sin(pi/4;`.
std::string_view missing_bracket(SymbolKind found, std::span<const SymbolKind> expected) {
  const bool ends_statement =
      found == Symbols::S_SEMICOLON || found == Symbols::S_RIGHT_BRACE || found == Symbols::S_YYEOF;
  return ends_statement && contains(expected, Symbols::S_RIGHT_PARENTHESIS) ? ", expected `)`" : "";
}

}  // namespace

SyntaxMessage syntax_message(SymbolKind found, std::string_view text, std::span<const SymbolKind> expected) {
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
