// An independent definition of the solids, as signed functions in long double, without any solving. Tests compare
// crossings with it.
#pragma once

#include "renderer/solids/solid.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace isl::render::test {

using Real = long double;

struct RealVec {
  Real x, y, z;
};

inline RealVec operator-(const RealVec& a, const RealVec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Real dot(const RealVec& a, const RealVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline RealVec real(const Vec3& v) { return {v.x, v.y, v.z}; }
inline RealVec along(const Vec3& o, const Vec3& d, Real t) { return {o.x + t * d.x, o.y + t * d.y, o.z + t * d.z}; }

/// A length that is negative inside the solid, zero on its surface, and positive outside; near the surface it is about
/// the distance.
inline Real signed_gap(const scene::Solid& solid, const RealVec& p) {
  using scene::SolidKind;
  const RealVec a = real(solid.a);
  if (solid.kind == SolidKind::plane) return dot(p, a) - static_cast<Real>(solid.radius_a);
  const RealVec from_a = p - a;
  if (solid.kind == SolidKind::sphere) return std::sqrt(dot(from_a, from_a)) - static_cast<Real>(solid.radius_a);
  const RealVec span = real(solid.b) - a;
  const Real length = std::sqrt(dot(span, span));
  const Real height = dot(from_a, span) / length;
  const RealVec across{from_a.x - height / length * span.x, from_a.y - height / length * span.y,
                       from_a.z - height / length * span.z};
  const Real radius_a = solid.radius_a;
  const Real radius_b = solid.kind == SolidKind::cone ? solid.radius_b : solid.radius_a;
  const Real slope = (radius_b - radius_a) / length;
  const Real side = (std::sqrt(dot(across, across)) - (radius_a + slope * height)) / std::sqrt(1 + slope * slope);
  return std::max({side, -height, height - length});
}

/// The approximate size of the solid.
inline double size_of(const scene::Solid& solid) {
  return (solid.b - solid.a).length() + solid.radius_a + solid.radius_b;
}

/// Random numbers for tests of up to 10^5 cases, the same on every machine.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  Vec3 in_cube(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
  Vec3 direction() {
    while (true) {
      const Vec3 v = in_cube(1);
      if (v.length() > 0.1 && v.length() < 1) return v.normalized();
    }
  }

 private:
  std::mt19937_64 engine_;
};

/// A closed solid of about unit size near the origin. Every fourth cone has its apex at a, every fourth at b.
inline scene::Solid random_solid(Random& random, scene::SolidKind kind) {
  scene::Solid solid;
  solid.kind = kind;
  if (kind == scene::SolidKind::plane) {
    solid.a = random.direction();
    solid.radius_a = random.uniform(-1, 1);
    return solid;
  }
  solid.a = random.in_cube(1);
  solid.radius_a = random.uniform(0.05, 1);
  if (kind == scene::SolidKind::sphere) return solid;
  solid.b = solid.a + random.direction() * random.uniform(0.2, 2);
  if (kind == scene::SolidKind::cone) {
    solid.radius_b = random.uniform(0.05, 1);
    const double form = random.uniform(0, 4);
    if (form < 1) solid.radius_a = 0;
    if (form >= 3) solid.radius_b = 0;
  }
  return solid;
}

inline constexpr scene::SolidKind kAllKinds[] = {scene::SolidKind::sphere, scene::SolidKind::cylinder,
                                                 scene::SolidKind::cone, scene::SolidKind::plane};

/// A direction that leans from the surface by the sine `lean`; positive is outward.
inline Vec3 leaning(const Vec3& normal, double lean, Random& random) {
  const Vec3 across = normal.cross(random.direction()).normalized();
  return (across + normal * lean).normalized();
}

/// The number of crossings ahead of the start.
inline int positive(const Crossings& found) {
  int count = 0;
  for (int i = 0; i < found.count; ++i) count += found.t[static_cast<std::size_t>(i)] > 0 ? 1 : 0;
  return count;
}

}  // namespace isl::render::test
