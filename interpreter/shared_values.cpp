#include "interpreter/shared_values.h"

namespace isl::interpreter {

std::string_view describe(const Value& value) {
  switch (value.kind()) {
    case ValueKind::none: return "an array element that is not set";
    case ValueKind::poison: return "nothing";
    case ValueKind::numeric: {
      static constexpr std::string_view kNames[] = {
          "", "a number", "a 2-term vector", "a 3-term vector", "a 4-term vector", "a colour"};
      return kNames[value.term_count()];
    }
    case ValueKind::string: return "a string";
    case ValueKind::array: return "an array";
    case ValueKind::dictionary: return "a dictionary";
    case ValueKind::macro: return "a macro";
    case ValueKind::object: return "an object";
    case ValueKind::pigment: return "a pigment";
    case ValueKind::normal: return "a normal";
    case ValueKind::finish: return "a finish";
    case ValueKind::texture: return "a texture";
    case ValueKind::material: return "a material";
    case ValueKind::interior: return "an interior";
    case ValueKind::colour_map: return "a color_map";
    case ValueKind::pigment_map: return "a pigment_map";
    case ValueKind::normal_map: return "a normal_map";
    case ValueKind::slope_map: return "a slope_map";
    case ValueKind::texture_map: return "a texture_map";
    case ValueKind::statement: return value.as<StatementValue>().statement.kind->noun;
    case ValueKind::transform: return "a transform";
    case ValueKind::camera: return "a camera";
    case ValueKind::function: return "a function";
    case ValueKind::spline: return "a spline";
    case ValueKind::file: return "an open file";
    case ValueKind::deprecated: return "a deprecated name";
  }
  return "";
}

}  // namespace isl::interpreter
