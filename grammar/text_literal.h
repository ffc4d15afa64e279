// The two readings of a string literal. They have their own header because the generated parser's header needs it.
#pragma once

#include <string_view>

namespace isl::grammar {

/// `text` has its escapes resolved; `raw` is the text between the quotes. Both outlive the parse.
struct TextLiteral {
  std::string_view text;
  std::string_view raw;
};

}  // namespace isl::grammar
