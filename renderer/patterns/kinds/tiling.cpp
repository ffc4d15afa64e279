// The tilings of the plane of x and z, by number: polygons that repeat (1 to 24) and those by Penrose (25 to 27).
#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/patterns/kinds/penrose.h"
#include "renderer/patterns/kinds/periodic_polygons.h"

namespace isl::render {
namespace {

struct Tiling {
  int number = 1;
};
constexpr scene::OperandField kTiling[] = {scene::operand<&Tiling::number>("number")};

constexpr int kMost = kPolygonPlans + 3;

void read_tiling(scene::OperandReader& reader, Tiling& tiling, std::string_view /*word*/) noexcept {
  tiling.number = reader.whole_in("the number of a `tiling`", 1, kMost);
}

double tiling_at(const PatternPoint& at) noexcept {
  const int number = at.operands<Tiling>().number;
  switch (number - kPolygonPlans) {
    case 1: return penrose_pentagons(at.point);
    case 2: return penrose_kites(at.point);
    case 3: return penrose_rhombs(at.point);
    default: return periodic_polygons(number, at.point);
  }
}

}  // namespace

constinit const PatternInfo pattern_kinds::tiling{
    .operands = operands_of<Tiling, kTiling>, .read = read_operands<Tiling, read_tiling>, .value = tiling_at};

}  // namespace isl::render
