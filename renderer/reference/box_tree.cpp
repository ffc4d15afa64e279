// A place o + td in double precision is off by what origin and direction are off by, and by a few roundings. So the t
// at which it meets a face f, (f − o)/d, is off by a few roundings of itself, by the same share as d is, and by the
// error of o over d. NaN, of infinities of both signs, fails every comparison that would leave a box out.
#include "renderer/reference/box_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isl::ISL_REFERENCE {
namespace {

/// More than a few roundings in double precision.
constexpr double kFewRoundings = 0x1p-49;
constexpr Size kMargin = 1 + 0x1p-40L;

}  // namespace

bool Box::is_bounded() const {
  const auto is_finite = [](double x) { return std::abs(x) < kInfinite; };
  return std::ranges::all_of(low, is_finite) && std::ranges::all_of(high, is_finite);
}

void Box::take_in(const Box& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], other.low[i]);
    high[i] = std::max(high[i], other.high[i]);
  }
}

Box box_around(const Vector<Real>& centre, Real radius) { return box_before(centre, radius, scene::Matrix()); }

Box box_before(const Vector<Real>& centre, Real radius, const scene::Matrix& m) {
  // With rows, as the database has them, q = p·A + b. Let N be nearly the inverse of A, A·N = I + E, and p₀ any point,
  // r = centre − (p₀·A + b). A point p that lands at centre + s has (p − p₀)·A = r + s = v, and so p − p₀ = v·N − (p −
  // p₀)·E. With |v| ≤ R and n, ‖N‖ and ‖E‖ the lengths of a column and of all of N and E: |p − p₀| ≤ R‖N‖/(1 − ‖E‖),
  // and a coordinate of it is at most R·n + ‖E‖R‖N‖/(1 − ‖E‖).
  const auto entry = [&](std::size_t row, std::size_t column) {
    return static_cast<Real>(m[static_cast<int>(row)][static_cast<int>(column)]);
  };
  const auto row = [&](std::size_t i) { return Vector<Real>{entry(i, 0), entry(i, 1), entry(i, 2)}; };
  const Vector<Real> yz = cross(row(1), row(2)), zx = cross(row(2), row(0)), xy = cross(row(0), row(1));
  const Real determinant = dot(row(0), yz);
  if (!(abs(determinant) > 0)) return Box::everything();
  const std::array<Vector<Real>, 3> n{yz * (1 / determinant), zx * (1 / determinant),
                                      xy * (1 / determinant)};  // columns
  const auto exact = [](const Vector<Real>& v) { return Vector<Interval>{v.x, v.y, v.z}; };
  Real error_squared = 0, size_squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    size_squared += squared_length(n[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      const Interval off = dot(exact(row(i)), exact(n[j])) - Interval(i == j ? 1 : 0);
      error_squared += square(Real(off.magnitude()));
    }
  }
  const Real error = sqrt(error_squared), size = sqrt(size_squared);
  if (!(error < 0.5L)) return Box::everything();
  const Vector<Real> way = centre - row(3);
  const Vector<Real> p0{dot(way, n[0]), dot(way, n[1]), dot(way, n[2])};
  const auto image = [&](std::size_t column) {
    return dot(exact(p0), Vector<Interval>{entry(0, column), entry(1, column), entry(2, column)}) +
           Interval(entry(3, column));
  };
  const Vector<Interval> rest = exact(centre) - Vector<Interval>{image(0), image(1), image(2)};
  const Real reach = (radius + sqrt(squared_length(rest).hi())) * kMargin;
  Box box;
  const std::array<Real, 3> middle{p0.x, p0.y, p0.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const Real half = (reach * sqrt(squared_length(n[i])) + error * reach * size / (1 - error)) * kMargin;
    const auto low = static_cast<double>(middle[i] - half), high = static_cast<double>(middle[i] + half);
    box.low[i] = low - std::abs(low) * kFewRoundings;
    box.high[i] = high + std::abs(high) * kFewRoundings;
    if (!(box.low[i] <= box.high[i])) return Box::everything();
  }
  return box;
}

Box box_before(const Box& box, const scene::Matrix& destination_from_source) {
  if (box.is_empty()) return box;
  if (!box.is_bounded()) return Box::everything();
  const Vector<Real> low{box.low[0], box.low[1], box.low[2]}, high{box.high[0], box.high[1], box.high[2]};
  const Real half = sqrt(squared_length(high - low)) / 2 * kMargin;
  return box_before((low + high) * Real(0.5L), half, destination_from_source);
}

RoughLine::RoughLine(const Line& line) {
  const auto axis_of = [](const Interval& o, const Interval& d) {
    Axis axis{};
    axis.origin = static_cast<double>(o.middle());
    axis.origin_error = static_cast<double>((o - Interval(Real(axis.origin))).magnitude() * kMargin);
    const auto speed = static_cast<double>(d.middle());
    const auto off = static_cast<double>((d - Interval(Real(speed))).magnitude() * kMargin);
    axis.stands_still = d.magnitude() == 0;
    // Less speed than that, or a direction that may be either, tells nothing.
    axis.tells_nothing = !axis.stands_still && !(std::abs(speed) > std::max(8 * off, 1e-290));
    axis.inverse = 1 / speed;
    axis.share = 2 * off / std::abs(speed) + kFewRoundings;
    return axis;
  };
  axes_ = {axis_of(line.origin.x, line.direction.x), axis_of(line.origin.y, line.direction.y),
           axis_of(line.origin.z, line.direction.z)};
}

RoughLine::Stretch RoughLine::within(const Box& box) const {
  Stretch stretch{0, Box::kInfinite};
  for (std::size_t i = 0; i < 3; ++i) {
    const Axis& axis = axes_[i];
    if (axis.tells_nothing) continue;
    const double to_low = box.low[i] - axis.origin, to_high = box.high[i] - axis.origin;
    if (axis.stands_still) {
      const double slack = axis.origin_error + kFewRoundings * (std::abs(to_low) + std::abs(to_high));
      if (to_low > slack || to_high < -slack) return {1, 0};
      continue;
    }
    const double one = to_low * axis.inverse, other = to_high * axis.inverse;
    const double begin = std::min(one, other), end = std::max(one, other);
    const double slack = 2 * axis.origin_error * std::abs(axis.inverse);
    stretch.begin = std::max(stretch.begin, begin - std::abs(begin) * axis.share - slack);
    stretch.end = std::min(stretch.end, end + std::abs(end) * axis.share + slack);
  }
  return stretch;
}

BoxTree::BoxTree(const std::vector<Box>& boxes) {
  std::vector<std::uint32_t> bounded;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    bounds_.take_in(boxes[i]);
    (boxes[i].is_bounded() ? bounded : unbounded_).push_back(i);
  }
  nodes_.reserve(2 * bounded.size());
  if (!bounded.empty()) build(bounded, boxes);
}

void BoxTree::build(std::span<std::uint32_t> numbers, const std::vector<Box>& boxes) {
  const std::size_t place = nodes_.size();
  nodes_.emplace_back();
  Box all;
  for (const std::uint32_t i : numbers) all.take_in(boxes[i]);
  if (numbers.size() > 1) {
    std::size_t longest = 0;
    const auto length = [&](std::size_t i) { return all.high[i] - all.low[i]; };
    for (std::size_t i = 1; i < 3; ++i) longest = length(i) > length(longest) ? i : longest;
    const auto middle = [&](std::uint32_t i) { return boxes[i].low[longest] / 2 + boxes[i].high[longest] / 2; };
    const std::size_t half = numbers.size() / 2;
    std::ranges::nth_element(numbers, numbers.begin() + static_cast<std::ptrdiff_t>(half), {}, middle);
    build(numbers.first(half), boxes);
    build(numbers.subspan(half), boxes);
  }
  nodes_[place] = {all, static_cast<std::uint32_t>(nodes_.size()), numbers.size() == 1 ? numbers[0] : kInner};
}

void BoxTree::along(const RoughLine& line, std::vector<std::uint32_t>& numbers) const {
  const auto first = static_cast<std::ptrdiff_t>(numbers.size());
  numbers.insert(numbers.end(), unbounded_.begin(), unbounded_.end());
  for (std::size_t at = 0; at < nodes_.size();) {
    const Node& node = nodes_[at];
    const bool is_met = line.may_meet(node.box);
    if (is_met && node.number != kInner) numbers.push_back(node.number);
    at = is_met ? at + 1 : node.after;
  }
  std::sort(numbers.begin() + first, numbers.end());
}

}  // namespace isl::ISL_REFERENCE
