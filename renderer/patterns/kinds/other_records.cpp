// Patterns with the values of other records of the scene: a function, the brightness of a pigment.
#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/patterns/kinds/pigment_colour.h"

namespace isl::render {
namespace {

double function_at(const PatternPoint& at) noexcept {
  const scene::FunctionId id = std::get_if<scene::FunctionOperands>(&at.pattern.operands)->function;
  if (id == scene::kNoFunction) return 0;
  const double arguments[] = {at.point.x, at.point.y, at.point.z};
  return below_1(values::evaluate(*at.world.database.functions[index(id)], arguments, at.environment)[0]);
}

double pigment_at(const PatternPoint& at) noexcept {
  const scene::Pigment pigment{.pattern = std::get_if<scene::PigmentOperands>(&at.pattern.operands)->pigment};
  return gray(at.world.patterns.pigment_colour(pigment, at.point, at.environment));
}

}  // namespace

constinit const PatternInfo pattern_kinds::function{.block = PatternBlock::function, .value = function_at};
constinit const PatternInfo pattern_kinds::pigment_pattern{.block = PatternBlock::pigment, .value = pigment_at};

}  // namespace isl::render
