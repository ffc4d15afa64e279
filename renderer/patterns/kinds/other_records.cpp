// Patterns with the values of other records of the scene: a function, the brightness of a pigment, the field of a blob,
// and a colour whose terms are functions.
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

double potential_at(const PatternPoint& at) noexcept {
  const auto& operands = *std::get_if<scene::ObjectOperands>(&at.pattern.operands);
  if (operands.object == scene::kNone || !at.world.surroundings) return 0;
  const scene::Database& database = at.world.database;
  const scene::Object& object = database.pattern_objects[operands.object];
  double field = at.world.surroundings->field_of(object, at.point, at.environment.steps());
  if (operands.less_threshold) field -= database.blobs[object.shape].threshold;
  return object.inverse ? -field : field;
}

scene::Colour colour_of_functions(const PatternPoint& at) noexcept {
  const double arguments[] = {at.point.x, at.point.y, at.point.z};
  const auto& terms = std::get_if<scene::ColourOperands>(&at.pattern.operands)->terms;
  const auto value_of = [&](std::size_t term) {
    if (terms[term] == scene::kNoFunction) return 0.0;
    return values::evaluate(*at.world.database.functions[index(terms[term])], arguments, at.environment)[0];
  };
  return in_single({value_of(0), value_of(1), value_of(2), value_of(3), value_of(4)});
}

}  // namespace

constinit const PatternInfo pattern_kinds::function{.block = PatternBlock::function, .value = function_at};
constinit const PatternInfo pattern_kinds::pigment_pattern{.block = PatternBlock::pigment, .value = pigment_at};
constinit const PatternInfo pattern_kinds::potential{
    .block = PatternBlock::blob, .wave = scene::Wave::none, .value = potential_at};
constinit const PatternInfo pattern_kinds::user_defined{.block = PatternBlock::colours,
                                                        .hosts = {.normal = false, .texture = false, .function = false},
                                                        .choice = PatternChoice::own,
                                                        .colour = colour_of_functions};

}  // namespace isl::render
