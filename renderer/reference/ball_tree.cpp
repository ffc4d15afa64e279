#include "renderer/reference/ball_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace isl::ISL_REFERENCE {
namespace {

constexpr std::size_t kFan = 8;
/// Far more than a few roundings in double precision.
constexpr Real kBallMargin = 1 + 0x1p-49L;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The smallest ball of its kind around some: the middle of their common box, and the radius that it takes.
Ball around(const Ball* first, const Ball* last) {
  std::array<double, 3> low, high;
  low.fill(kInfinite);
  high.fill(-kInfinite);
  for (const Ball* ball = first; ball != last; ++ball) {
    const std::array<double, 3> at{ball->x, ball->y, ball->z};
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], at[i] - ball->radius);
      high[i] = std::max(high[i], at[i] + ball->radius);
    }
  }
  const auto middle = [&](std::size_t i) { return low[i] / 2 + high[i] / 2; };
  Ball all{middle(0), middle(1), middle(2), 0};
  Real radius = 0;
  for (const Ball* ball = first; ball != last; ++ball) {
    const Vector<Real> to{static_cast<Real>(ball->x) - all.x, static_cast<Real>(ball->y) - all.y,
                          static_cast<Real>(ball->z) - all.z};
    radius = std::max(radius, sqrt(squared_length(to)) + ball->radius);
  }
  all.radius = static_cast<double>(radius * kBallMargin);
  return all;
}

/// The place of a point on Morton's curve: the bits of its three coordinates in turn, 20 of each.
std::uint64_t morton_place(const std::array<double, 3>& share) {
  std::uint64_t place = 0;
  std::array<std::uint32_t, 3> whole{};
  for (std::size_t i = 0; i < 3; ++i) whole[i] = static_cast<std::uint32_t>(std::clamp(share[i], 0.0, 1.0) * 0xfffff);
  for (int bit = 19; bit >= 0; --bit) {
    for (std::size_t i = 0; i < 3; ++i) place = 2 * place + (whole[i] >> bit & 1);
  }
  return place;
}

}  // namespace

Ball rounded_ball(const Vector<Real>& centre, Real radius) {
  Ball ball{static_cast<double>(centre.x), static_cast<double>(centre.y), static_cast<double>(centre.z), kInfinite};
  const Vector<Real> off{centre.x - ball.x, centre.y - ball.y, centre.z - ball.z};
  // The centre itself was computed with a few roundings of 2⁻⁶⁴.
  const Real far = sqrt(squared_length(centre));
  const Real whole = (radius + sqrt(squared_length(off)) + far * 0x1p-60L) * kBallMargin;
  // Beyond this a double's squares overflow. NaN fails the comparison, too.
  if (whole < 1e150L && far < 1e150L) ball.radius = static_cast<double>(whole);
  return ball;
}

Ball ball_before(const Vector<Real>& centre, Real radius, const scene::Matrix& m) {
  // With rows, as the database has them, q = p·A + b. Let N be nearly the inverse of A, A·N = I + E, and p₀ any point,
  // ρ = centre − (p₀·A + b). A point p that lands at centre + r has (p − p₀)·A = r + ρ, so that
  //   |p − p₀|(1 − ‖E‖) ≤ |(p − p₀)·A·N| ≤ (|r| + |ρ|)‖N‖.
  const auto entry = [&](int row, int column) { return static_cast<Real>(m[row][column]); };
  const auto row = [&](int i) { return Vector<Real>{entry(i, 0), entry(i, 1), entry(i, 2)}; };
  const Vector<Real> x = row(0), y = row(1), z = row(2), b = row(3);
  const Vector<Real> yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
  const Real determinant = dot(x, yz);
  const Ball everything{0, 0, 0, kInfinite};
  if (!(abs(determinant) > 0)) return everything;
  // The columns of N.
  const std::array<Vector<Real>, 3> n{yz * (1 / determinant), zx * (1 / determinant), xy * (1 / determinant)};
  const auto exact = [](const Vector<Real>& v) { return Vector<Interval>{v.x, v.y, v.z}; };
  Real error_squared = 0, size_squared = 0;
  for (int i = 0; i < 3; ++i) {
    size_squared += squared_length(n[i]);
    for (int j = 0; j < 3; ++j) {
      const Real off = (dot(exact(row(i)), exact(n[j])) - Interval(i == j ? 1 : 0)).magnitude();
      error_squared += off * off;
    }
  }
  const Real error = sqrt(error_squared);
  if (!(error < 0.5L)) return everything;
  const Vector<Real> from = centre - b;
  const Vector<Real> p0{dot(from, n[0]), dot(from, n[1]), dot(from, n[2])};
  const auto image = [&](int column) {
    return Interval(p0.x) * Interval(entry(0, column)) + Interval(p0.y) * Interval(entry(1, column)) +
           Interval(p0.z) * Interval(entry(2, column)) + Interval(entry(3, column));
  };
  const Vector<Interval> rest = exact(centre) - Vector<Interval>{image(0), image(1), image(2)};
  const Real off = sqrt(squared_length(rest).hi);
  return rounded_ball(p0, (radius + off) * sqrt(size_squared) / (1 - error) * kBallMargin);
}

RoughLine::RoughLine(const FieldRay& ray) {
  const auto round = [](const Vector<Interval>& v, scene::Vec3& to) {
    const std::array<const Interval*, 3> parts{&v.x, &v.y, &v.z};
    Real off = 0;
    for (int i = 0; i < 3; ++i) {
      to[i] = static_cast<double>(parts[static_cast<std::size_t>(i)]->middle());
      off += (*parts[static_cast<std::size_t>(i)] - Interval(static_cast<Real>(to[i]))).magnitude();
    }
    return static_cast<double>(off * kBallMargin);
  };
  origin_error = round(ray.origin, origin);
  direction_error = round(ray.direction, direction);
  length = std::sqrt(direction.dot(direction));
}

bool RoughLine::may_meet(const Ball& ball) const {
  const scene::Vec3 w(ball.x - origin.x, ball.y - origin.y, ball.z - origin.z);
  const scene::Vec3 across = w.cross(direction);
  const double far = std::sqrt(w.dot(w));
  const double off = 0x1p-49 * far * length + origin_error * length + direction_error * far;
  return !(std::sqrt(across.dot(across)) > (ball.radius * length + off) * (1 + 0x1p-49));
}

double RoughLine::earliest(const Ball& ball) const {
  const scene::Vec3 w(ball.x - origin.x, ball.y - origin.y, ball.z - origin.z);
  const double t = (std::sqrt(w.dot(w)) * (1 - 0x1p-49) - origin_error - ball.radius) / (length + direction_error);
  return t > 0 ? t * (1 - 0x1p-49) : 0;  // also 0 for NaN
}

BallTree::BallTree(const std::vector<Ball>& balls) {
  std::array<double, 3> low, high;
  low.fill(kInfinite);
  high.fill(-kInfinite);
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const Ball& ball = balls[i];
    if (!(ball.radius < kInfinite)) {
      unbounded_.push_back(i);
      continue;
    }
    number_at_.push_back(i);
    const std::array<double, 3> at{ball.x, ball.y, ball.z};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], at[k]);
      high[k] = std::max(high[k], at[k]);
    }
  }
  if (number_at_.empty()) return;
  std::vector<std::uint64_t> keys(balls.size());
  for (const std::uint32_t i : number_at_) {
    const std::array<double, 3> at{balls[i].x, balls[i].y, balls[i].z};
    std::array<double, 3> share{};
    for (std::size_t k = 0; k < 3; ++k) share[k] = high[k] > low[k] ? (at[k] - low[k]) / (high[k] - low[k]) : 0;
    keys[i] = morton_place(share);
  }
  std::ranges::stable_sort(number_at_, {}, [&](std::uint32_t i) { return keys[i]; });
  std::vector<Ball>& lowest = levels_.emplace_back();
  lowest.reserve(number_at_.size());
  for (const std::uint32_t i : number_at_) lowest.push_back(balls[i]);
  while (levels_.back().size() > 1) {
    const std::vector<Ball>& below = levels_.back();
    std::vector<Ball> level;
    for (std::size_t i = 0; i < below.size(); i += kFan) {
      level.push_back(around(below.data() + i, below.data() + std::min(i + kFan, below.size())));
    }
    levels_.push_back(std::move(level));
  }
}

Ball BallTree::bounds() const {
  if (!unbounded_.empty()) return {0, 0, 0, kInfinite};
  return levels_.empty() ? Ball{0, 0, 0, -1} : levels_.back().front();
}

void BallTree::descend(std::size_t level, std::size_t place, const RoughLine& line,
                       std::vector<std::uint32_t>& numbers) const {
  if (!line.may_meet(levels_[level][place])) return;
  if (level == 0) {
    numbers.push_back(number_at_[place]);
    return;
  }
  const std::size_t end = std::min((place + 1) * kFan, levels_[level - 1].size());
  for (std::size_t below = place * kFan; below < end; ++below) descend(level - 1, below, line, numbers);
}

void BallTree::along(const RoughLine& line, std::vector<std::uint32_t>& numbers) const {
  const auto first = static_cast<std::ptrdiff_t>(numbers.size());
  numbers.insert(numbers.end(), unbounded_.begin(), unbounded_.end());
  if (!levels_.empty()) descend(levels_.size() - 1, 0, line, numbers);
  std::sort(numbers.begin() + first, numbers.end());
}

}  // namespace isl::ISL_REFERENCE
