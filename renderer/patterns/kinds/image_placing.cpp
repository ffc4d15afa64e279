#include "renderer/patterns/kinds/image_placing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

using scene::Vec3;

constexpr double kFullTurn = 2 * std::numbers::pi;

/// The angle about y from +x towards +z, in full turns from 0 to 1.
double turn_of(double x, double z) {
  const double angle = std::atan2(z, x);
  return (angle < 0 ? angle + kFullTurn : angle) / kFullTurn;
}

/// The weights of four neighbours by Catmull and Rom, at a share `t` of the way from the second to the third.
std::array<double, 4> cubic_weights(double t) {
  const double t2 = t * t, t3 = t2 * t;
  return {(-t3 + 2 * t2 - t) / 2, (3 * t3 - 5 * t2 + 2) / 2, (-3 * t3 + 4 * t2 + t) / 2, (t3 - t2) / 2};
}

}  // namespace

std::optional<TexelPlace> ImagePlacing::place_of(const Vec3& p) const noexcept {
  double u = p.x, v = p.y;
  switch (map_type_) {
    case 1: {
      const double length = p.length();
      u = turn_of(p.x, p.z);
      v = length > 0 ? 0.5 + std::asin(std::clamp(p.y / length, -1.0, 1.0)) / std::numbers::pi : 0;
      break;
    }
    case 2: u = turn_of(p.x, p.z); break;
    case 5: {
      const double outward = std::sqrt(p.x * p.x + p.z * p.z) - 1;
      const double around = std::atan2(p.y, -outward);
      u = turn_of(p.x, p.z);
      v = (around < 0 ? -around : kFullTurn - around) / kFullTurn;
      break;
    }
    case 7: {
      // A picture of all directions around +z: the distance from its centre is the angle to +z, so that its border is
      // −z, which itself is shown by the centre, as in POV-Ray.
      const double across = std::sqrt(p.x * p.x + p.y * p.y);
      const double share = across > 0 ? std::atan2(across, p.z) / (kFullTurn * across) : 0;
      u = 0.5 + p.x * share;
      v = 0.5 + p.y * share;
      break;
    }
    default: break;
  }
  u = u * repeat_x_ - offset_x_;
  v = v * repeat_y_ - offset_y_;
  if (once_ && !(u >= 0 && u <= 1 && v >= 0 && v <= 1)) return std::nullopt;
  return TexelPlace{u * width_, v * height_};
}

TexelPlace ImagePlacing::neighbour(const TexelPlace& place, double dx, double dy) const noexcept {
  if (!once_) return {place.x + dx, place.y + dy};  // texels repeat
  const auto within = [](double value, int size) { return value - std::floor(value / size) * size; };
  return {within(place.x + dx, width_), within(place.y + dy, height_)};
}

TexelTaps ImagePlacing::taps_of(const TexelPlace& place) const noexcept {
  TexelTaps taps;
  if (!mixes_texels()) {
    taps.add(texel_at(place), 1);
    return taps;
  }
  // Texels stand for their centres.
  const double x = place.x - 0.5, y = place.y - 0.5;
  const double left = std::floor(x), low = std::floor(y);
  const double right_share = x - left, high_share = y - low;
  if (interpolate_ == 3) {
    const std::array<double, 4> across = cubic_weights(right_share), up = cubic_weights(high_share);
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        taps.add(texel_number(left - 1 + static_cast<double>(column), low - 1 + static_cast<double>(row)),
                 across[column] * up[row]);
      }
    }
    return taps;
  }
  double sum = 0;
  const std::size_t columns[2] = {column_number(left), column_number(left + 1)};
  for (const int up : {0, 1}) {
    const std::size_t row = row_start(low + up);
    for (const int across : {0, 1}) {
      const std::size_t texel = row + columns[across];
      const double dx = across - right_share, dy = up - high_share;
      const double near = interpolate_ == 2 ? (1 - std::abs(dx)) * (1 - std::abs(dy)) : dx * dx + dy * dy;
      if (interpolate_ == 4 && near == 0) {
        taps.count = 0;
        taps.add(texel, 1);
        return taps;
      }
      const double weight = interpolate_ == 2 ? near : 1 / near;
      taps.add(texel, weight);
      sum += weight;
    }
  }
  if (interpolate_ == 2) return taps;  // these add up to 1
  for (int i = 0; i < taps.count; ++i) taps.taps[static_cast<std::size_t>(i)].weight /= sum;
  return taps;
}

}  // namespace isl::render
