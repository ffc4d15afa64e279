// Plain values in the dump of the database. Internal to renderer/scene.
#pragma once

#include "renderer/scene/colour.h"
#include "renderer/scene/transform.h"

#include <nlohmann/json.hpp>

#include <string_view>

namespace isl::scene {

using Json = nlohmann::ordered_json;

/// The name of an enumerator, from a table in the order of the enumeration.
template <std::size_t count, class Enum>
[[nodiscard]] std::string_view name(const std::string_view (&names)[count], Enum value) {
  return names[static_cast<std::size_t>(value)];
}

[[nodiscard]] inline Json vector(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

/// Red, green, blue; then filter and transmit, unless both are 0.
[[nodiscard]] inline Json colour(const Colour& c) {
  Json json = Json::array({c.red, c.green, c.blue});
  if (c.filter != 0 || c.transmit != 0) {
    json.push_back(c.filter);
    json.push_back(c.transmit);
  }
  return json;
}

/// The images of x, y, z, then of the origin.
[[nodiscard]] inline Json transform(const Transform& t) {
  Json json = Json::array();
  for (int row = 0; row < 4; ++row) json.push_back(Json::array({t.matrix[row][0], t.matrix[row][1], t.matrix[row][2]}));
  return json;
}

}  // namespace isl::scene
