// Line ends of a text. As in POV-Ray, each of LF, CR, CR LF and LF CR is one end of a line, in any mixture: files come
// from Unix, from old Macs and from DOS.
#pragma once

#include <cstddef>
#include <string_view>

namespace isl::grammar {

inline constexpr std::string_view kLineEndBytes = "\r\n";

/// Size in bytes of the line end at `at`, which holds CR or LF: 2 for a pair of both, else 1.
[[nodiscard]] constexpr std::size_t line_end_size(std::string_view text, std::size_t at) {
  if (at + 1 == text.size() || text[at + 1] == text[at]) return 1;
  return kLineEndBytes.find(text[at + 1]) == std::string_view::npos ? 1 : 2;
}

}  // namespace isl::grammar
