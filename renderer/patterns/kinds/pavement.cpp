// Polyforms that pave the plane of x and z. Not evaluated yet.
#include "renderer/patterns/kinds/pattern_kind.h"

#include <fmt/format.h>

namespace isl::render {
namespace {

struct Pavement {
  int sides = 3;
  int tiles = 1;
  int pattern = 1;
  int form = 0;
  int interior = 0;
  int exterior = 0;
};

void read_sides(scene::OperandReader& reader, Pavement& pavement) noexcept {
  pavement.sides = static_cast<int>(reader.number("`number_of_sides`"));
  if (pavement.sides != 3 && pavement.sides != 4 && pavement.sides != 6)
    reader.fail(fmt::format("`number_of_sides` is 3, 4 or 6, found {}", pavement.sides));
}

constexpr scene::OperandField kPavement[] = {
    scene::modifier<&Pavement::sides>("number_of_sides").read_by<read_sides>(),
    scene::modifier<&Pavement::tiles>("number_of_tiles").within(1, 6),
    scene::modifier<&Pavement::pattern>("pattern").within(1, 22).with_key("number"),
    scene::modifier<&Pavement::form>("form").within(0, 3),
    scene::modifier<&Pavement::interior>("interior").within(0, 2),
    scene::modifier<&Pavement::exterior>("exterior").within(0, 2)};

}  // namespace

constinit const PatternInfo pattern_kinds::pavement{.operands = operands_of<Pavement, kPavement>,
                                                    .lack = PatternLack::formula};

}  // namespace isl::render
