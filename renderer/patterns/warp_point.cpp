#include "renderer/patterns/warp_point.h"

#include "renderer/patterns/kinds/random_cubes.h"
#include "renderer/patterns/kinds/turbulence.h"
#include "renderer/patterns/mapping_warps.h"
#include "renderer/values/integer.h"
#include "renderer/values/noise.h"
#include "renderer/values/single_precision.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

using scene::Vec3;
using values::to_single;

/// Along an axis with a smaller block there is no repetition.
constexpr double kLeastRepeat = 0.001;

Vec3 apply(const scene::Turbulence& t, const Vec3& p) {
  const Vec3 push = values::vector_turbulence(p, octaves_of(t));
  return {p.x + push.x * t.amount.x, p.y + push.y * t.amount.y, p.z + push.z * t.amount.z};
}

Vec3 apply(const scene::RepeatWarp& warp, Vec3 p) {
  const double width = to_single(warp.width);
  const double block = std::floor(p[warp.axis] / width);
  p[warp.axis] -= to_single(block * width);
  if (values::is_odd(block)) {
    for (int i = 0; i < 3; ++i) {
      if (warp.flip[i] != 0) p[i] = -p[i];
    }
    if (warp.flip[warp.axis] != 0) p[warp.axis] += width;
  }
  return p + warp.offset * block;
}

/// The centre of the block around p.
Vec3 centre_near(const scene::BlackHoleWarp& warp, const Vec3& p) {
  if (!warp.repeats) return warp.centre;
  Vec3 centre = warp.centre, block(0);
  for (int i = 0; i < 3; ++i) {
    if (warp.repeat[i] < kLeastRepeat) continue;
    // The black hole is moved and the block enlarged until it contains the whole of it.
    centre[i] = std::max(centre[i], warp.radius);
    const double room = centre[i] + warp.radius + (warp.is_turbulent ? warp.turbulence[i] : 0);
    const double size = std::max(warp.repeat[i], room);
    block[i] = std::floor(p[i] / size);
    centre[i] += size * block[i];
  }
  if (!warp.is_turbulent) return centre;
  const double* const random = random_cubes().of(cube_of(block));
  return centre + Vec3(random[0] * warp.turbulence.x, random[1] * warp.turbulence.y, random[2] * warp.turbulence.z);
}

/// p + (p − centre) · min(strength · (1 − distance / radius)^falloff, 1): the pattern shrinks towards the centre.
Vec3 apply(const scene::BlackHoleWarp& warp, const Vec3& p) {
  const Vec3 offset = p - centre_near(warp, p);
  const double distance = std::sqrt(offset.dot(offset));
  if (!(distance < warp.radius)) return p;
  const double strength = std::min(warp.strength * std::pow((warp.radius - distance) / warp.radius, warp.falloff), 1.0);
  return warp.inverse ? p - offset * strength : p + offset * strength;
}

struct Warper {
  const scene::Database& database;
  const Vec3& point;
  Vec3 operator()(scene::TransformId id) const { return database.transforms[index(id)].inverse_point(point); }
  Vec3 operator()(const scene::MappingWarp& warp) const { return mapped(warp, point); }
  template <class Warp>
  Vec3 operator()(const Warp& warp) const {
    return apply(warp, point);
  }
};

}  // namespace

Vec3 warped(const scene::Database& database, const scene::Pattern& pattern, Vec3 point,
            PointTurbulence turbulence) noexcept {
  for (auto warp = pattern.warps.rbegin(); warp != pattern.warps.rend(); ++warp)
    point = std::visit(Warper{database, point}, *warp);
  if (turbulence == PointTurbulence::yes && pattern.turbulence.amount != Vec3(0))
    point = apply(pattern.turbulence, point);
  return within_limit(point);
}

}  // namespace isl::render
