// A place in the user's text: byte offsets into the virtual concatenation of all files read. Only grammar/source_map.h
// turns offsets into file, line and column.
#pragma once

#include <algorithm>
#include <cstdint>

namespace isl {

/// Half-open range of bytes [begin, end). {0, 0} means "nowhere" (the first file starts at offset 1).
struct SourceSpan {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  [[nodiscard]] constexpr bool empty() const { return begin == 0 && end == 0; }
  friend constexpr bool operator==(SourceSpan, SourceSpan) = default;
};

/// The smallest span that holds both; an empty one adds nothing.
[[nodiscard]] constexpr SourceSpan join(SourceSpan a, SourceSpan b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

/// Identifies the source span and the macro call chain that made a primitive, without their text: the renderer carries
/// these ids, and only cli resolves one, through the interpreter's OriginTable. 0 is "unknown".
struct OriginId {
  std::uint32_t value = 0;
  friend constexpr bool operator==(OriginId, OriginId) = default;
};

}  // namespace isl
