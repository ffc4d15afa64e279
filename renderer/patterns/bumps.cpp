// Bumps: normals bent by patterns, as in POV-Ray. The normal is taken into the pattern's own space by the transforms
// among its warps (other warps move points only), made a unit vector, bent, and taken back. Because of its unit length,
// scaled bumps are as steep as before, unless `no_bump_scale` leaves its length as it is.
#include "renderer/patterns/kinds/waveform.h"
#include "renderer/patterns/map_interval.h"
#include "renderer/patterns/own_space.h"
#include "renderer/patterns/patterns.h"

#include <array>
#include <cstddef>
#include <iterator>
#include <limits>

namespace isl::render {
namespace {

using scene::Normal;
using values::Environment;

Vec3 unit(const Vec3& v, const Vec3& otherwise) noexcept {
  const double length = v.length();
  return length >= std::numeric_limits<double>::min() ? v * (1 / length) : otherwise;
}

/// Height where the pattern has this value: a cubic between two entries.
double height_at(const scene::SlopeMap& map, double value) noexcept {
  const auto interval = find_in(map, value);
  const scene::SlopeEntry &a = *interval.first, &b = *interval.second;
  if (&a == &b) return b.height;
  const double t = interval.fraction, s = 1 - t;
  return s * s * ((1 + 2 * t) * a.height + t * a.slope) + t * t * ((1 + 2 * s) * b.height - s * b.slope);
}

}  // namespace

Vec3 Patterns::bent(const Normal& bumps, const Vec3& point, const Vec3& normal,
                    Environment& environment) const noexcept {
  if (!environment.take_step()) return normal;
  const scene::Pattern& pattern = bumps.pattern;
  if (pattern.kind == scene::PatternKind::plain) return normal;
  const Vec3 p = own_point(world_.database, pattern, point, environment);
  Vec3 n = into_own_space(world_.database, pattern, normal);
  if (!bumps.no_bump_scale) n = unit(n, normal);
  if (bumps.map != scene::kNoNormalMap) {
    n = bent_by_map(bumps, p, n, environment);
  } else if (const auto bend = info_of(pattern.kind).bend) {
    n = bend({pattern, p, environment, world_}, n, bumps.bump_size);
  } else {
    n = bent_by_heights(bumps, p, n, environment);
  }
  return unit(out_of_own_space(world_.database, pattern, n), normal);
}

Vec3 Patterns::bent_by_map(const Normal& bumps, const Vec3& p, const Vec3& normal,
                           Environment& environment) const noexcept {
  const scene::NormalMap& map = world_.database.normal_maps[index(bumps.map)];
  const auto of_entry = [&](const scene::NormalEntry& entry) {
    if (entry.normal == scene::kNoNormal) return normal;
    return bent(world_.database.normals[index(entry.normal)], p, normal, environment);
  };
  if (info_of(bumps.pattern.kind).choice == PatternChoice::mean_of_map) {
    Vec3 sum(0);
    double total = 0;
    for (const scene::NormalEntry& entry : map) {
      if (environment.is_spent()) return normal;
      sum += of_entry(entry) * entry.value;
      total += entry.value;
    }
    return total == 0 ? normal : sum / total;
  }
  const auto interval = find_in(map, value_at_own_point(bumps.pattern, p, environment));
  const Vec3 second = of_entry(*interval.second);
  if (interval.first == interval.second) return second;
  return of_entry(*interval.first) * (1 - interval.fraction) + second * interval.fraction;
}

Vec3 Patterns::bent_by_heights(const Normal& bumps, const Vec3& p, const Vec3& normal,
                               Environment& environment) const noexcept {
  // The corners of a tetrahedron around the point. Their heights' sum, each along its corner, is about 4/3 of the
  // gradient times their distance; POV-Ray's factor makes 2/15 of the gradient of it where `accuracy` is 0.02.
  static constexpr double kCorners[][3] = {{0.942809041, -0.333333333, 0},
                                           {-0.471404521, -0.333333333, 0.816496581},
                                           {-0.471404521, -0.333333333, -0.816496581},
                                           {0, 1, 0}};
  constexpr std::size_t kCornerCount = std::size(kCorners);
  const auto corner = [](std::size_t i) { return Vec3(kCorners[i][0], kCorners[i][1], kCorners[i][2]); };
  constexpr double kStandardAccuracy = 0.02, kSteepness = 5;
  const double factor = kSteepness * bumps.bump_size * (kStandardAccuracy / bumps.accuracy);
  std::array<Vec3, kCornerCount> points;
  for (std::size_t i = 0; i < kCornerCount; ++i) points[i] = p + corner(i) * bumps.accuracy;
  std::array<double, kCornerCount> heights{};
  values_near(bumps.pattern, p, points, heights, environment);
  Vec3 n = normal;
  for (std::size_t i = 0; i < kCornerCount; ++i) {
    double height = in_wave(heights[i], bumps.pattern);
    if (bumps.slope_map != scene::kNoSlopeMap)
      height = height_at(world_.database.slope_maps[index(bumps.slope_map)], height);
    n -= corner(i) * (factor * height);
  }
  return n;
}

}  // namespace isl::render
