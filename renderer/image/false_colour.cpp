#include "renderer/image/false_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isl::render {
namespace {

/// Lightness L and the opponent axes a (green to red), b (blue to yellow).
struct OkLab {
  double lightness, a, b;
};

double distance(const OkLab& p, const OkLab& q) { return std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b); }

/// Corners of the path, chosen as (lightness, chroma, hue in degrees): (0.22, 0.10, 275), (0.46, 0.10, 255), (0.62,
/// 0.10, 190), (0.80, 0.15, 135), (0.95, 0.16, 105). The whole path lies within sRGB.
constexpr std::array<OkLab, 5> kPath{{{0.22, 0.0087, -0.0996},
                                      {0.46, -0.0259, -0.0966},
                                      {0.62, -0.0985, -0.0174},
                                      {0.80, -0.1061, 0.1061},
                                      {0.95, -0.0414, 0.1545}}};

/// Converts to linear sRGB by the published matrices.
Rgb linear_of(const OkLab& c) {
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(c.lightness + 0.3963377774 * c.a + 0.2158037573 * c.b);
  const double m = cube(c.lightness - 0.1055613458 * c.a - 0.0638541728 * c.b);
  const double s = cube(c.lightness - 0.0894841775 * c.a - 1.2914855480 * c.b);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

}  // namespace

Rgb false_colour(double share) {
  double whole = 0;
  for (std::size_t i = 1; i < kPath.size(); ++i) whole += distance(kPath[i - 1], kPath[i]);
  double way = share > 0 ? std::min(share, 1.0) * whole : 0;
  for (std::size_t i = 1; i < kPath.size(); ++i) {
    const OkLab &p = kPath[i - 1], &q = kPath[i];
    const double length = distance(p, q);
    if (way > length && i + 1 < kPath.size()) {
      way -= length;
      continue;
    }
    const double u = std::min(way / length, 1.0);
    return linear_of({p.lightness + u * (q.lightness - p.lightness), p.a + u * (q.a - p.a), p.b + u * (q.b - p.b)});
  }
  return linear_of(kPath.back());
}

double ColourScale::share_of(double value) const {
  if (!is_logarithmic) return (value - low) / (high - low);
  return value > low ? std::log(value / low) / std::log(high / low) : 0;
}

}  // namespace isl::render
