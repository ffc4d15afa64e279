// "Did you mean": the known word nearest to a misspelt one. Used for directives here, for words and identifiers by the
// evaluator. It does not know the source of either.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace isl::grammar {

/// The least number of insertions, deletions, replacements and swaps of neighbours that turn one text into the other
/// (optimal string alignment: no letter is touched twice), or limit + 1 if it is more than `limit`. Compares bytes.
[[nodiscard]] std::size_t edit_distance(std::string_view from, std::string_view to, std::size_t limit);

/// The candidate nearest to `word`, the first of equals; none when all are further than a third of its length, or when
/// it is so short that anything would be near. A difference of upper and lower case alone always counts as near.
[[nodiscard]] std::optional<std::string_view> closest(std::string_view word,
                                                      std::span<const std::string_view> candidates);

}  // namespace isl::grammar
