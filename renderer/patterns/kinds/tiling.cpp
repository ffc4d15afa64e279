// Tilings of the plane of x and z. Not evaluated yet.
#include "renderer/patterns/kinds/pattern_kind.h"

namespace isl::render {
namespace {

struct Tiling {
  int number = 1;
};
constexpr scene::OperandField kTiling[] = {scene::operand<&Tiling::number>("number")};

void read_tiling(scene::OperandReader& reader, Tiling& tiling, std::string_view /*word*/) noexcept {
  tiling.number = reader.whole_in("the number of a `tiling`", 1, 27);
}

}  // namespace

constinit const PatternInfo pattern_kinds::tiling{
    .operands = operands_of<Tiling, kTiling>, .read = read_operands<Tiling, read_tiling>, .lack = PatternLack::formula};

}  // namespace isl::render
