#include "renderer/patterns/kinds/polyforms.h"

#include "base/check.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace isl::render {
namespace {

constexpr Polyform kPolyforms[] = {
#define ISL_POLYFORM(sides, tiles, columns, rows, shift, borders) {sides, tiles, columns, rows, shift, borders},
#include "renderer/patterns/kinds/polyforms.def"
#undef ISL_POLYFORM
};

/// The first polyform of one size, and the number of them.
struct Range {
  std::size_t first = 0;
  int count = 0;
};
constexpr std::size_t kMostSides = 6, kMostTilesOfForm = 6;

constexpr auto kRanges = [] {
  std::array<std::array<Range, kMostTilesOfForm + 1>, kMostSides + 1> ranges{};
  for (std::size_t i = 0; i < std::size(kPolyforms); ++i) {
    Range& range = ranges[static_cast<std::size_t>(kPolyforms[i].sides)][static_cast<std::size_t>(kPolyforms[i].tiles)];
    if (range.count++ == 0) range.first = i;
  }
  return ranges;
}();

Range range_of(int sides, int tiles) noexcept {
  return kRanges[static_cast<std::size_t>(sides)][static_cast<std::size_t>(tiles)];
}

/// From 0 to below the divisor.
template <class Integer>
Integer remainder_of(Integer value, Integer divisor) noexcept {
  const Integer rest = value % divisor;
  return rest < 0 ? rest + divisor : rest;
}

const Polyform& polyform_of(int sides, int tiles, int number) noexcept {
  const Range range = range_of(sides, tiles);
  ISL_DCHECK(number >= 1 && number <= range.count, "polyform {} of {} sides and {} tiles", number, sides, tiles);
  return kPolyforms[range.first + static_cast<std::size_t>(number) - 1];
}

}  // namespace

int polyform_count(int sides, int tiles) noexcept { return range_of(sides, tiles).count; }

PolyformBorders::PolyformBorders(int sides, int tiles, int number) noexcept
    : polyform_(polyform_of(sides, tiles, number)) {}

bool PolyformBorders::operator()(double column, double row, int bit) const noexcept {
  constexpr double kMost = 0x1p30;
  if (!(std::abs(column) < kMost && std::abs(row) < kMost)) return false;
  const auto i = static_cast<std::int64_t>(column);
  const auto j = static_cast<std::int32_t>(row);
  const std::int32_t row_in_block = remainder_of(j, polyform_.rows);
  const std::int64_t blocks = (j - row_in_block) / polyform_.rows;
  const auto along = remainder_of(i - blocks * polyform_.shift, std::int64_t{polyform_.columns});
  const auto place = static_cast<std::size_t>(std::int64_t{row_in_block} * polyform_.columns + along);
  return ((polyform_.borders[place] - '0') >> bit & 1) != 0;
}

}  // namespace isl::render
