// The message for a token that the grammar does not expect. It folds the many tokens that could stand there into a few
// ideas that users know. It knows the parser's symbols and no state.
#pragma once

#include "grammar/parser.hh"

#include <span>
#include <string>
#include <string_view>

namespace isl::grammar {

struct SyntaxMessage {
  std::string message;  ///< "unexpected `)`, expected an expression"
  std::string hint;     ///< may be empty
};

/// `text` is the found token as written in the source.
[[nodiscard]] SyntaxMessage syntax_message(Parser::symbol_kind_type found, std::string_view text,
                                           std::span<const Parser::symbol_kind_type> expected);

}  // namespace isl::grammar
