#include "renderer/solids/solid_details.h"

#include "renderer/scene/database.h"

namespace isl::render {

SolidDetails prepare_details(const scene::Database& database) {
  SolidDetails details;
  details.polynomials.reserve(database.polynomials.size());
  for (const scene::Polynomial& polynomial : database.polynomials) details.polynomials.push_back(prepare(polynomial));
  details.triangles = database.triangles;
  details.polygons.reserve(database.polygons.size());
  for (const scene::Polygon& polygon : database.polygons) details.polygons.push_back(prepare(polygon));
  return details;
}

}  // namespace isl::render
