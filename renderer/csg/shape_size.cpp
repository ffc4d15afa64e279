#include "renderer/csg/shape_size.h"

#include "renderer/solids/solid.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

using scene::Database;

double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

double size_of(const scene::Blob& blob) {
  double size = 0;
  for (const scene::Component& c : blob.components) {
    size = std::max({size, largest(c.a), largest(c.b), std::abs(c.radius_a), std::abs(c.radius_b)});
  }
  return size;
}

}  // namespace

double shape_size(const Database& database, scene::Object::Kind kind, std::uint32_t shape) {
  return kind == scene::Object::Kind::solid ? size_of(database, database.solids[shape])
                                            : size_of(database.blobs[shape]);
}

}  // namespace isl::render
