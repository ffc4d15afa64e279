// Skeletons on the way to collapsing: triangles whose corners are almost on a line, edges, segments, circles and discs
// of 10⁻¹⁶ beside coordinates of 1. The distance is compared with one from the definition in 113 bits: the least over
// all features, without any decision by planes that could go wrong in the same way.
#include "renderer/fields/component_table.h"
#include "renderer/fields/record_skeleton.h"
#include "tests/support/ray_fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace isl::render {
namespace {

__extension__ using Quad = __float128;

struct QuadVector {
  Quad x, y, z;
  explicit QuadVector(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
  QuadVector(Quad x_, Quad y_, Quad z_) : x(x_), y(y_), z(z_) {}
  friend QuadVector operator+(const QuadVector& a, const QuadVector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend QuadVector operator-(const QuadVector& a, const QuadVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend QuadVector operator*(const QuadVector& a, Quad s) { return {a.x * s, a.y * s, a.z * s}; }
};
Quad dot(const QuadVector& a, const QuadVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
QuadVector cross(const QuadVector& a, const QuadVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Quad square(const QuadVector& v) { return dot(v, v); }

/// Squared distances.
Quad to_segment(const QuadVector& p, const QuadVector& a, const QuadVector& b) {
  const QuadVector along = b - a, from = p - a;
  const Quad length2 = square(along);
  Quad s = length2 > 0 ? dot(from, along) / length2 : 0;
  s = s < 0 ? Quad(0) : s > 1 ? Quad(1) : s;
  return square(from - along * s);
}
Quad to_triangle(const QuadVector& p, const QuadVector& a, const QuadVector& b, const QuadVector& c) {
  const QuadVector n = cross(b - a, c - a);
  const auto is_behind = [&](const QuadVector& from, const QuadVector& to) {
    return dot(p - from, cross(to - from, n)) <= 0;
  };
  if (is_behind(a, b) && is_behind(b, c) && is_behind(c, a)) {
    const Quad height = dot(p - a, n);
    return height * height / square(n);
  }
  return std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
}
/// q of a round cone: the quotient is unimodal in u, so that a search by thirds finds its least value.
Quad cone_q(const QuadVector& p, const scene::Component& c) {
  const QuadVector a(c.a), along = QuadVector(c.b) - a;
  const auto at = [&](Quad s) {
    const Quad r = c.radius_a + (Quad(c.radius_b) - c.radius_a) * s;
    return square(p - a - along * s) / (r * r);
  };
  Quad low = 0, high = 1;
  for (int i = 0; i < 250; ++i) {
    const Quad third = (high - low) / 3;
    (at(low + third) < at(high - third) ? high : low) = at(low + third) < at(high - third) ? high - third : low + third;
  }
  return std::min({at(0), at(1), at(low)});
}

class Random {
 public:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  /// From 10^low to 10^high.
  double size(double low, double high) { return std::pow(10, between(low, high)); }
  bool is_heads() { return between(0, 1) < 0.5; }
  Vec3 direction() {
    Vec3 v(0);
    while (v.length() < 0.1 || v.length() > 1) v = {between(-1, 1), between(-1, 1), between(-1, 1)};
    return v.normalized();
  }

 private:
  std::mt19937_64 random_{20260715};
};

/// A component of the quartic kernel, with a third corner.
struct Collapsing {
  scene::Blob blob;
  scene::Component component;
  double extent = 0;  ///< greatest distance of the skeleton from the origin

  explicit Collapsing(scene::Skeleton skeleton) {
    component.skeleton = skeleton;
    blob.threshold = 0;
  }
  void finish(const Vec3& third) {
    blob.corners.push_back(third);
    blob.components.push_back(component);
    blob.origins.push_back({});
    extent = std::max({component.a.length(), component.b.length(), third.length()});
  }
  [[nodiscard]] double q(const Vec3& p) const {
    return with_skeleton_of(blob, component, [&](const auto& skeleton) { return skeleton.nearest(p).q(); });
  }
  [[nodiscard]] Quad exact_q(const Vec3& point) const {
    const QuadVector p(point), a(component.a), b(component.b);
    const Quad r = component.radius_a;
    switch (component.skeleton) {
      case scene::Skeleton::triangle: return to_triangle(p, a, b, QuadVector(blob.corners[0])) / (r * r);
      case scene::Skeleton::segment: return to_segment(p, a, b) / (r * r);
      default: return cone_q(p, component);
    }
  }
};

/// A triangle of about `size`, of which one corner is `thin` · size away from another, or from the opposite edge.
Collapsing thin_triangle(Random& random, double size, double thin) {
  Collapsing result(scene::Skeleton::triangle);
  const Vec3 at = random.direction() * (random.is_heads() ? 0 : random.size(-3, 2));
  const Vec3 along = random.direction() * size, across = along.cross(random.direction()) * thin;
  Vec3 corners[3] = {at, at + along, at + (random.is_heads() ? along * random.between(0, 1) : Vec3(0)) + across};
  std::rotate(corners, corners + static_cast<int>(random.between(0, 3)), corners + 3);
  result.component.a = corners[0];
  result.component.b = corners[1];
  result.component.radius_a = size * random.size(-3, 0);
  result.finish(corners[2]);
  return result;
}

/// True if the reader would have made a segment of it (interpreter/readers/objects/blob_component.cpp).
bool is_flat(const Collapsing& c) {
  const QuadVector a(c.component.a), b(c.component.b), third(c.blob.corners[0]);
  const Quad longest2 = std::max({square(b - a), square(third - b), square(a - third)});
  return square(cross(b - a, third - a)) <= Quad(0x1.1p-48) * 0x1.1p-48 * longest2 * longest2;
}

/// A point about the triangle: beside it, above it, or just beyond an edge or a corner.
Vec3 point_about(Random& random, const Collapsing& c, double size) {
  const Vec3 a = c.component.a, ab = c.component.b - a, ac = c.blob.corners[0] - a;
  double u = random.between(-0.1, 1.1), v = random.between(-0.1, 1.1);
  if (random.is_heads()) u = std::round(u);
  if (random.is_heads()) v = std::round(v);
  return a + ab * u + ac * v + random.direction() * (size * random.size(-16, 1));
}

/// √q may differ by a few roundings of the coordinates, over the radius. For a cone that its thick end holds to the
/// last bit, q may differ by the rounding of 1 (renderer/fields/record_skeleton.h).
void expect_right(const Collapsing& c, const Vec3& p, double thin) {
  const bool is_cone = c.component.skeleton == scene::Skeleton::cone;
  const auto exact_q = static_cast<long double>(c.exact_q(p));
  const auto found_q = static_cast<long double>(c.q(p));
  if (is_cone && std::abs(found_q - exact_q) <= 0x1p-53L) return;
  const long double radius = is_cone ? std::min(c.component.radius_a, c.component.radius_b) : c.component.radius_a;
  const long double rounding = 0x1p-53L * (c.extent + p.length()) / radius;
  const long double exact = std::sqrt(exact_q), found = std::sqrt(found_q);
  ASSERT_LE(std::abs(found - exact), 16 * rounding + 8 * 0x1p-53L * exact)
      << "thin " << thin << ", at " << p << ", exactly " << static_cast<double>(exact) << " from " << c.component.a
      << ' ' << c.component.b << ' ' << c.blob.corners[0];
}

TEST(CollapsingSkeletons, TrianglesAreRightHoweverThin) {
  Random random;
  int tried = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double size = random.size(-3, 3), thin = random.size(-15, 0);
    const Collapsing triangle = thin_triangle(random, size, thin);
    if (is_flat(triangle)) continue;
    for (int j = 0; j < 10; ++j) {
      expect_right(triangle, point_about(random, triangle, size), thin);
      ++tried;
    }
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tried, 100'000);
}

TEST(CollapsingSkeletons, SegmentsAndConesAreRightHoweverShort) {
  Random random;
  for (int i = 0; i < 3'000; ++i) {
    Collapsing limb(random.is_heads() ? scene::Skeleton::segment : scene::Skeleton::cone);
    const double size = random.size(-3, 3), thin = random.size(-20, 0);
    limb.component.a = random.direction() * (random.is_heads() ? 0 : size);
    limb.component.b = limb.component.a + random.direction() * (size * thin);
    limb.component.radius_a = size * random.size(-3, 0);
    limb.component.radius_b = random.is_heads() ? size * random.size(-3, 0) : limb.component.radius_a * (1 + thin);
    limb.finish(Vec3(0));
    for (int j = 0; j < 4; ++j)
      expect_right(limb, limb.component.a + random.direction() * (size * random.size(-16, 1)), thin);
    if (HasFatalFailure()) return;
  }
}

TEST(CollapsingSkeletons, FieldsAlongRaysAreThoseOfPoints) {
  scene::Database database;
  database.kernels.push_back({scene::KernelShape::quartic, scene::RadiusMeaning::surface, 4});
  const KernelConstants kernel = kernel_constants(database.kernels[0]);
  Random random;
  int met = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double thin = random.size(-15, 0);
    Collapsing shape = thin_triangle(random, 1, thin);
    if (i % 2 == 0) {
      shape.component.skeleton = i % 4 == 0 ? scene::Skeleton::segment : scene::Skeleton::cone;
      shape.component.b = shape.component.a + random.direction() * thin;
      shape.component.radius_b = 0.3;
      shape.blob.components[0] = shape.component;
    } else if (is_flat(shape)) {
      continue;
    }
    const double r = shape.component.radius_a;
    const Vec3 near = point_about(random, shape, r), direction = random.direction();
    const Vec3 origin = near - direction * random.between(0, 5);
    const ComponentTable table = compile_components(database, shape.blob);
    const double t = (near - origin).length();
    const test::RayFields fields(table, origin, direction, t - 0.1 * r, t + 0.1 * r);
    const double found = fields.at(t).value;
    const double exact = kernel_value(kernel, static_cast<double>(shape.exact_q(origin + direction * t)));
    met += exact > 0;
    // |dF/d√q| ≤ 2·amplitude·2√q/Q·(1 − q/Q) < 2 amplitude/√Q.
    const double least = shape.component.skeleton == scene::Skeleton::cone ? std::min(r, shape.component.radius_b) : r;
    const double rounding = 0x1p-53 * (shape.extent + origin.length() + 10) / least;
    ASSERT_NEAR(found, exact, 2 * kernel.amplitude * (32 * rounding + 0x1p-48)) << "thin " << thin << ", number " << i;
  }
  EXPECT_GT(met, 1'000);
}

/// The window of a convolution at y, from docs/language.md.
double window_at(const KernelConstants& kernel, double y) {
  if (!(y < 1)) return 0;
  if (kernel.shape == scene::KernelShape::quartic) return (1 - y) * (1 - y);
  const double at = kernel.a + y, border = kernel.a + 1;
  return (1 - y) * (1 - y) * (border + 2 * at) / (at * at * border * border * border);
}

TEST(CollapsingSkeletons, AShortConvolvedSegmentIsItsLengthTimesTheWindow) {
  Random random;
  for (int i = 0; i < 2'000; ++i) {
    scene::Database database;
    const auto shape = random.is_heads() ? scene::KernelShape::quartic : scene::KernelShape::cauchy;
    database.kernels.push_back(
        {shape, scene::RadiusMeaning::surface, random.size(0, 1), scene::FieldMode::convolution});
    const KernelConstants kernel = kernel_constants(database.kernels[0]);
    Collapsing short_one(scene::Skeleton::segment);
    scene::Component& c = short_one.component;
    c.radius_a = random.size(-2, 1);
    c.b = random.direction() * (c.radius_a * random.size(-16, -7));
    short_one.finish(Vec3(0));
    const double support = c.radius_a / std::sqrt(kernel.scale), length = c.b.length() / support;
    const Vec3 p = c.b * 0.5 + random.direction() * (support * random.between(0, 0.9));
    const double y = (p - c.b * 0.5).length2() / (support * support);
    const double exact = kernel.amplitude * length * window_at(kernel, y);
    // The window's curvature counts with the square of the length, at most 10⁻¹⁴, over ε, which is above 10⁻².
    EXPECT_NEAR(field_at(database, short_one.blob, c, kernel, p), exact, 1e-11 * exact) << length << " at y = " << y;
  }
  // Of no length it is nothing, and takes no part.
  scene::Database database;
  database.kernels.push_back(
      {scene::KernelShape::quartic, scene::RadiusMeaning::surface, 4, scene::FieldMode::convolution});
  Collapsing none(scene::Skeleton::segment);
  none.component.radius_a = 1;
  none.finish(Vec3(0));
  EXPECT_EQ(field_at(database, none.blob, none.component, kernel_constants(database.kernels[0]), Vec3(0)), 0);
  EXPECT_EQ(compile_components(database, none.blob).size(), 0U);
}

TEST(CollapsingSkeletons, ACircleAndADiscOfNoSizeAreTheirCentre) {
  for (const scene::Skeleton skeleton : {scene::Skeleton::circle, scene::Skeleton::disc}) {
    for (const double ring : {1e-9, 1e-12, 1e-15, 1e-300}) {
      Collapsing shape(skeleton);
      shape.component.b = Vec3(0, 1, 0);
      shape.component.radius_a = 0.5;
      shape.component.radius_b = ring;
      shape.finish(Vec3(0));
      const Vec3 p(0.3, -0.2, 0.1);
      EXPECT_NEAR(std::sqrt(shape.q(p)), p.length() / 0.5, 2 * ring + 0x1p-51) << ring;
    }
  }
}

TEST(CollapsingSkeletons, TheCoordinatesOfAThinTriangleAreFiniteAndWithinIt) {
  Random random;
  for (int i = 0; i < 5'000; ++i) {
    const Collapsing triangle = thin_triangle(random, 1, random.size(-15, 0));
    if (is_flat(triangle)) continue;
    const FlatTriangle shape(triangle.blob, triangle.component);
    const Coordinates at = shape.coordinates(point_about(random, triangle, 1), {});
    EXPECT_TRUE(at.u >= 0 && at.u <= 1 && at.v >= 0 && at.v <= 1) << at.u << ' ' << at.v;
  }
}

}  // namespace
}  // namespace isl::render
