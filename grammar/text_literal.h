// The two readings of a string literal. A header of its own because the generated parser's header needs it.
#pragma once

#include <string_view>

namespace isl::grammar {

/// `text` with escapes resolved; `raw` as it stands between the quotes. Both outlive the parse.
struct TextLiteral {
  std::string_view text;
  std::string_view raw;
};

}  // namespace isl::grammar
