#include "interpreter/readers/textures/default_maps.h"

#include "interpreter/records.h"
#include "renderer/patterns/kinds/pattern_kind.h"

#include <span>

namespace isl::interpreter {
namespace {

using render::info_of;
using render::PatternColour;
using render::PatternInfo;
using scene::PigmentMap;

PigmentMap map_of(std::span<const PatternColour> colours) {
  PigmentMap map;
  for (const PatternColour& colour : colours) map.push_back({colour.value, {{colour.red, colour.green, colour.blue}}});
  return map;
}

scene::PigmentMapId shared_map(Context& context, std::span<const PatternColour> colours) {
  const auto [place, is_new] = context.default_maps.try_emplace({colours.data(), colours.size()}, scene::kNoPigmentMap);
  if (is_new) place->second = add_map<scene::PigmentMapId>(context, context.database.pigment_maps, map_of(colours));
  return place->second;
}

}  // namespace

scene::PigmentMapId default_pigment_map(Context& context, const scene::Pattern& pattern) {
  const PatternInfo& info = info_of(pattern.kind);
  const auto* const operands = std::get_if<scene::Operands>(&pattern.operands);
  const bool is_coloured = !info.has_colours || (operands && info.has_colours(operands->record));
  return shared_map(context, is_coloured ? info.colours : render::kBlackToWhite);
}

PigmentMap default_pigment_list(scene::PatternKind kind) { return map_of(info_of(kind).colours); }

scene::PigmentMapId default_pigment_list_id(Context& context, scene::PatternKind kind) {
  return shared_map(context, info_of(kind).colours);
}

}  // namespace isl::interpreter
