#include "grammar/suggest.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>
#include <vector>

namespace isl::grammar {
namespace {

/// One slip in a word of three to five letters, two up to eight, three beyond: more would propose unrelated words.
std::size_t allowed_distance(std::size_t length) { return std::min<std::size_t>(length / 3, 3); }

bool equal_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// Length limit of words that are compared letter by letter, which takes the product of their lengths.
constexpr std::size_t kLongestWord = 64;

}  // namespace

std::size_t edit_distance(std::string_view from, std::string_view to, std::size_t limit) {
  const std::size_t gap = from.size() > to.size() ? from.size() - to.size() : to.size() - from.size();
  if (gap > limit) return limit + 1;
  // Rows of the usual table: distances from the first i - 2, i - 1 and i letters of `from` to every prefix of `to`.
  std::vector<std::size_t> before_last(to.size() + 1), last(to.size() + 1), row(to.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return std::min(last[to.size()], limit + 1);
}

std::optional<std::string_view> closest(std::string_view word, std::span<const std::string_view> candidates) {
  std::optional<std::string_view> best;
  std::size_t best_distance = allowed_distance(word.size()) + 1;
  for (const std::string_view candidate : candidates) {
    if (candidate == word) continue;
    if (equal_but_for_case(word, candidate)) return candidate;
    if (best_distance == 1 || word.size() > kLongestWord) continue;
    const std::size_t distance = edit_distance(word, candidate, best_distance - 1);
    if (distance >= best_distance) continue;
    best = candidate;
    best_distance = distance;
  }
  return best;
}

}  // namespace isl::grammar
