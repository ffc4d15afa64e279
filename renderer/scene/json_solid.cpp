#include "renderer/scene/json_solid.h"

#include "renderer/scene/json_values.h"

#include <array>
#include <span>

namespace isl::scene {
namespace {

constexpr std::string_view kSolidKinds[] = {"sphere", "cylinder",       "cone",     "plane",           "box",
                                            "torus",  "disc",           "quadric",  "cubic",           "quartic",
                                            "poly",   "superellipsoid", "triangle", "smooth_triangle", "polygon"};
static_assert(std::size(kSolidKinds) == kSolidKindCount);

Json vectors(std::span<const Vec3> list) {
  Json json = Json::array();
  for (const Vec3& v : list) json.push_back(vector(v));
  return json;
}

/// Which of the record's fields a kind uses, and what they are in it; "" for none.
struct Fields {
  std::string_view a, b, radius_a, radius_b;
};
constexpr Fields kFields[] = {
    {"a", "", "radius", ""},                   // sphere
    {"a", "b", "radius", ""},                  // cylinder
    {"a", "b", "radius", "radius_b"},          // cone
    {"a", "", "distance", ""},                 // plane
    {"a", "b", "", ""},                        // box
    {"", "", "major_radius", "minor_radius"},  // torus
    {"a", "normal", "radius", "hole"},         // disc
    {},                                        // quadric
    {},                                        // cubic
    {},                                        // quartic
    {},                                        // poly
    {"", "", "e", "n"},                        // superellipsoid
    {},                                        // triangle
    {},                                        // smooth_triangle
    {},                                        // polygon
};
static_assert(std::size(kFields) == kSolidKindCount);

}  // namespace

Json solid_json(const Database& database, const Solid& solid) {
  Json json = {{"kind", name(kSolidKinds, solid.kind)}};
  const Fields& fields = kFields[static_cast<std::size_t>(solid.kind)];
  if (!fields.a.empty()) json[std::string(fields.a)] = vector(solid.a);
  if (!fields.b.empty()) json[std::string(fields.b)] = vector(solid.b);
  if (!fields.radius_a.empty()) json[std::string(fields.radius_a)] = solid.radius_a;
  if (!fields.radius_b.empty()) json[std::string(fields.radius_b)] = solid.radius_b;
  if (solid.open) json["open"] = true;
  if (is_polynomial(solid.kind)) {
    const Polynomial& polynomial = database.polynomials[solid.detail];
    json["order"] = polynomial.order;
    json["coefficients"] = polynomial.coefficients;
  } else if (is_triangle(solid.kind)) {
    const Triangle& triangle = database.triangles[solid.detail];
    json["corners"] = vectors(triangle.corners);
    if (solid.kind == SolidKind::smooth_triangle) json["normals"] = vectors(triangle.normals);
  } else if (solid.kind == SolidKind::polygon) {
    json["points"] = vectors(database.polygons[solid.detail].points);
  }
  return json;
}

}  // namespace isl::scene
