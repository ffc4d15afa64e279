// Far from the origin the terms of the highest order n, the form Fₙ, decide. If Fₙ ≥ c > 0 wherever the largest
// coordinate is 1, then, with Bₖ the sum of the absolute coefficients of order k and m the largest coordinate of a
// point,
//   P ≥ c mⁿ − Σₖ₍ₖ<ₙ₎ Bₖ mᵏ,
// which is positive for all m ≥ R once it is at R and all Bₖ Rᵏ⁻ⁿ only fall from there. c comes from interval
// arithmetic over pieces of the faces of the cube, halved until each is positive or there are too many. An odd order
// has no such c, and an even one the same values on opposite faces.
#include "renderer/solids/polynomial_bound.h"

#include "renderer/numerics/bernstein.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace isl::render {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
/// Pieces of a face and levels of halving: a form that needs more comes too close to zero to bound anything near.
constexpr std::size_t kMostPieces = 256;

struct Interval {
  double low, high;
};

Interval power_of(const Interval& x, int n) {
  double low = 1, high = 1;
  for (int i = 0; i < n; ++i) {
    low *= x.low;
    high *= x.high;
  }
  if (low > high) std::swap(low, high);
  if (n > 0 && n % 2 == 0 && x.low < 0 && x.high > 0) low = 0;
  return {low, high};
}

Interval product(const Interval& a, const Interval& b) {
  const double p[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  return {*std::min_element(p, p + 4), *std::max_element(p, p + 4)};
}

/// A lower bound of Fₙ on a box.
double least_of_form(const PreparedPolynomial& polynomial, const std::array<Interval, 3>& box) {
  const int n = polynomial.order;
  std::array<std::array<Interval, kMostDegree + 1>, 3> powers;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int k = 0; k <= n; ++k) powers[axis][static_cast<std::size_t>(k)] = power_of(box[axis], k);
  }
  double low = 0, largest = 0;
  std::size_t place = 0;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= i; ++j) {
      const double c = polynomial.coefficients[place];
      place += static_cast<std::size_t>(j) + 1;
      if (c == 0) continue;
      const Interval term =
          product(product(powers[0][static_cast<std::size_t>(n - i)], powers[1][static_cast<std::size_t>(i - j)]),
                  powers[2][static_cast<std::size_t>(j)]);
      low += c > 0 ? c * term.low : c * term.high;
      largest += std::abs(c);
    }
  }
  // No coordinate is beyond 1, so neither is any term beyond its coefficient; some 40 roundings each.
  return low - 0x1p-46 * largest;
}

/// One corner of the box: if Fₙ is not positive there, no bound exists and the search ends.
std::array<Interval, 3> corner_of(const std::array<Interval, 3>& box) {
  return {Interval{box[0].low, box[0].low}, Interval{box[1].low, box[1].low}, Interval{box[2].low, box[2].low}};
}

/// A lower bound of Fₙ over the cube's surface; not positive if positivity cannot be shown.
double least_on_cube(const PreparedPolynomial& polynomial) {
  double least = kNone;
  for (std::size_t face = 0; face < 3; ++face) {
    std::vector<std::array<Interval, 3>> pieces(1);
    pieces[0].fill({-1, 1});
    pieces[0][face] = {1, 1};
    for (std::size_t done = 0; done < pieces.size(); ++done) {
      const std::array<Interval, 3> piece = pieces[done];
      const double low = least_of_form(polynomial, piece);
      if (!(low > 0) && !(least_of_form(polynomial, corner_of(piece)) > 0)) return 0;
      const std::array<std::size_t, 2> sides = {(face + 1) % 3, (face + 2) % 3};
      const double width = piece[sides[0]].high - piece[sides[0]].low;
      // A few halvings more than positivity needs make the bound tight.
      if (low > 0 && width <= 0.25) {
        least = std::min(least, low);
        continue;
      }
      if (pieces.size() + 4 > kMostPieces) return 0;
      for (int quarter = 0; quarter < 4; ++quarter) {
        std::array<Interval, 3> part = piece;
        for (std::size_t side = 0; side < 2; ++side) {
          Interval& own = part[sides[side]];
          const double middle = 0.5 * (own.low + own.high);
          ((quarter >> side & 1) != 0 ? own.low : own.high) = middle;
        }
        pieces.push_back(part);
      }
    }
  }
  return least;
}

}  // namespace

double cube_of(const PreparedPolynomial& polynomial) {
  const int n = polynomial.order;
  if (n == 0 || n % 2 != 0) return kNone;
  const double c = least_on_cube(polynomial);
  if (!(c > 0) || !std::isfinite(c)) return kNone;
  std::array<double, kMostDegree + 1> sums{};
  std::size_t place = 0;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= i; ++j) {
      for (int k = 0; k <= j; ++k) sums[static_cast<std::size_t>(n - k)] += std::abs(polynomial.coefficients[place++]);
    }
  }
  // Σ Bₖ Rᵏ⁻ⁿ falls with R: from where it is below c, by doubling, then by halving the bracket to a part in a hundred.
  const auto lower_orders = [&](double r) {
    double sum = 0;
    for (int k = 0; k < n; ++k) sum = (sum + sums[static_cast<std::size_t>(k)]) / r;
    return sum;
  };
  if (!(polynomial.reach > 0)) return kNone;  // the form alone: a point
  double high = polynomial.reach;
  while (!(lower_orders(high) < 0.999 * c)) {
    high *= 2;
    if (!std::isfinite(high)) return kNone;
  }
  double low = 0;
  while (high - low > 0.01 * high) {
    const double middle = 0.5 * (low + high);
    (lower_orders(middle) < 0.999 * c ? high : low) = middle;
  }
  // Over the cube the terms, and so their rounding, grow by (cube/reach)ⁿ beyond what they are near the surface: a
  // loose cube would cost more digits than it spares rays.
  constexpr int kBitsToLose = 20;
  return n * (std::ilogb(high / polynomial.reach) + 1) <= kBitsToLose ? high : kNone;
}

}  // namespace isl::render
