#include "renderer/queries/inside.h"

#include "base/check.h"
#include "renderer/fields/component_table.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace isl::render {

using scene::Component;
using scene::Database;
using scene::Object;
using scene::Operation;
using scene::Solid;
using scene::SolidKind;

namespace {

bool in_cone(const Solid& solid, double radius_b, const Vec3& point) {
  const Vec3 axis = solid.b - solid.a, from_a = point - solid.a;
  const double along = from_a.dot(axis) / axis.dot(axis);
  if (!(along > 0 && along < 1)) return false;
  const double radius = solid.radius_a + (radius_b - solid.radius_a) * along;
  return (from_a - axis * along).length() < radius;
}

bool in_box(const Solid& solid, const Vec3& p) {
  for (int i = 0; i < 3; ++i) {
    if (p[i] < solid.a[i] || p[i] > solid.b[i]) return false;
  }
  return true;
}

bool in_superellipsoid(const Solid& solid, const Vec3& p) {
  const double e = solid.radius_a, n = solid.radius_b;
  const double ring = std::pow(std::abs(p.x), 2 / e) + std::pow(std::abs(p.y), 2 / e);
  return std::pow(ring, e / n) + std::pow(std::abs(p.z), 2 / n) <= 1;
}

/// Horner's rule, a polynomial in x whose coefficients are polynomials in y, whose coefficients are polynomials in z.
double value(const scene::Polynomial& polynomial, const Vec3& p) {
  const double* coefficient = polynomial.coefficients.data();
  double in_x = 0;
  for (int i = 0; i <= polynomial.order; ++i) {
    double in_y = 0;
    for (int j = 0; j <= i; ++j) {
      double in_z = 0;
      for (int k = 0; k <= j; ++k) in_z = in_z * p.z + *coefficient++;
      in_y = in_y * p.y + in_z;
    }
    in_x = in_x * p.x + in_y;
  }
  return in_x;
}

bool in_group(const Database& database, const std::vector<KernelConstants>& kernels, const scene::Group& group,
              const Vec3& point) {
  const auto holds = [&](const Object& child) { return is_inside(database, kernels, child, point); };
  switch (group.operation) {
    case Operation::unite:
    case Operation::merge: return std::ranges::any_of(group.children, holds);
    case Operation::intersect: return std::ranges::all_of(group.children, holds);
    case Operation::subtract:
      return !group.children.empty() && holds(group.children[0]) &&
             std::none_of(group.children.begin() + 1, group.children.end(), holds);
  }
  ISL_CHECK(false, "operation {}", static_cast<int>(group.operation));
}

bool in_shape(const Database& database, const std::vector<KernelConstants>& kernels, const Object& object,
              const Vec3& point) {
  switch (object.kind) {
    case Object::Kind::solid: return is_inside(database, database.solids[object.shape], point);
    case Object::Kind::blob: return is_inside(database, kernels, database.blobs[object.shape], point);
    case Object::Kind::group: return in_group(database, kernels, database.groups[object.shape], point);
  }
  ISL_CHECK(false, "object kind {}", static_cast<int>(object.kind));
}

}  // namespace

bool is_inside(const Database& database, const Solid& solid, const Vec3& p) {
  switch (solid.kind) {
    case SolidKind::sphere: return (p - solid.a).length() < solid.radius_a;
    case SolidKind::cylinder: return in_cone(solid, solid.radius_a, p);
    case SolidKind::cone: return in_cone(solid, solid.radius_b, p);
    case SolidKind::plane: return p.dot(solid.a) <= solid.radius_a;
    case SolidKind::box: return in_box(solid, p);
    case SolidKind::torus: return std::hypot(std::hypot(p.x, p.z) - solid.radius_a, p.y) <= solid.radius_b;
    case SolidKind::disc: return (p - solid.a).dot(solid.b) < 0;
    case SolidKind::quadric:
    case SolidKind::cubic:
    case SolidKind::quartic:
    case SolidKind::poly: return value(database.polynomials[solid.detail], p) <= 0;
    case SolidKind::superellipsoid: return in_superellipsoid(solid, p);
    case SolidKind::triangle:
    case SolidKind::smooth_triangle:
    case SolidKind::polygon: return false;
  }
  ISL_CHECK(false, "solid kind {}", static_cast<int>(solid.kind));
}

bool is_inside(const Database& database, const std::vector<KernelConstants>& kernels, const scene::Blob& blob,
               const Vec3& point) {
  const auto field_of = [&](const Component& c) {
    return c.strength * kernel_value(kernels[index(c.kernel)], q_at(database, blob, c, point));
  };
  if (blob.is_skeleton) {
    return std::ranges::any_of(blob.components, [&](const Component& c) { return field_of(c) >= blob.threshold; });
  }
  std::vector<double> sums(std::max<std::size_t>(blob.branches.size(), 1));
  for (std::size_t i = 0; i < blob.components.size(); ++i) {
    sums[blob.branches.empty() ? 0 : blob.branch_of[i]] += field_of(blob.components[i]);
  }
  BranchTree({blob.branches.begin(), blob.branches.end()}).add_up(sums);
  return sums[0] >= blob.threshold;
}

bool is_inside(const Database& database, const std::vector<KernelConstants>& kernels, const Object& object,
               const Vec3& point) {
  const Vec3 p = object.parent_from_object.inverse_point(point);
  if (in_shape(database, kernels, object, p) == object.inverse) return false;
  return object.clip == scene::kNoGroup || in_group(database, kernels, database.groups[index(object.clip)], p);
}

}  // namespace isl::render
