#include "renderer/csg/shape_size.h"

#include "renderer/solids/solid.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

using scene::Database;

double size_of(const scene::Blob& blob) {
  double size = 0;
  for (const scene::Component& c : blob.components) {
    size =
        std::max({size, largest_coordinate(c.a), largest_coordinate(c.b), std::abs(c.radius_a), std::abs(c.radius_b)});
  }
  return size;
}

}  // namespace

double shape_size(const Database& database, scene::Object::Kind kind, std::uint32_t shape) {
  return kind == scene::Object::Kind::solid ? size_of(database, database.solids[shape])
                                            : size_of(database.blobs[shape]);
}

}  // namespace isl::render
