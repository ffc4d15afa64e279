#include "renderer/patterns/kinds/polyforms.h"

#include "base/check.h"

#include <array>
#include <cmath>
#include <cstddef>

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
  const double blocks = std::floor(row / polyform_.rows), along = column - blocks * polyform_.shift;
  const double i = along - std::floor(along / polyform_.columns) * polyform_.columns;
  const double place = (row - blocks * polyform_.rows) * polyform_.columns + i;
  if (!(place >= 0 && place < static_cast<double>(polyform_.borders.size()))) return false;
  return ((polyform_.borders[static_cast<std::size_t>(place)] - '0') >> bit & 1) != 0;
}

}  // namespace isl::render
