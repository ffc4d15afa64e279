// P(x) = xᵀMx + 2g·x + c on a line x = p + s d about the line's foot p, its point nearest to the origin, is
//
//      A s² + 2B s + C,    A = dᵀMd,  B = dᵀ(Mp + g),  C = P(p)
//
// and its roots are q/A and C/q with q = −(B + sign(B)√D), D = B² − AC: nothing cancels between them. About the foot
// all terms are as small as they can be, so a far origin costs no digits. From a start on the surface, where the root 0
// is known, the other root is −2B/A with B at the start.
//
// Each of A, B and C is a sum of at most 20 products of at most 4 roundings, so it is off by less than 2⁻⁴⁷ of the sum
// of the sizes of its terms, for which the sums of the coefficients' sizes by order stand. The foot is off by less than
// 2⁻⁴⁷ of the origin's largest coordinate, which moves C by as much times the gradient.
#include "renderer/solids/quadric_line.h"

#include "renderer/solids/solid_type.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

double largest_of(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

class Quadric {
 public:
  explicit Quadric(const PreparedPolynomial& polynomial) : c_(polynomial.coefficients.data()) {}

  /// dᵀMd.
  [[nodiscard]] double second(const Vec3& d) const {
    return c_[0] * d.x * d.x + c_[4] * d.y * d.y + c_[7] * d.z * d.z + c_[1] * d.x * d.y + c_[2] * d.x * d.z +
           c_[5] * d.y * d.z;
  }
  /// 2(Mp + g).
  [[nodiscard]] Vec3 gradient(const Vec3& p) const {
    return {2 * c_[0] * p.x + c_[1] * p.y + c_[2] * p.z + c_[3], c_[1] * p.x + 2 * c_[4] * p.y + c_[5] * p.z + c_[6],
            c_[2] * p.x + c_[5] * p.y + 2 * c_[7] * p.z + c_[8]};
  }
  [[nodiscard]] double value(const Vec3& p) const {
    return second(p) + c_[3] * p.x + c_[6] * p.y + c_[8] * p.z + c_[9];
  }

 private:
  const double* c_;
};

}  // namespace

bool find_plain_crossings(const PreparedPolynomial& polynomial, const Vec3& origin, const Vec3& direction,
                          bool starts_on_surface, Crossings& found) noexcept {
  const Quadric quadric(polynomial);
  const auto [second, first, constant] = QuadricSizes(polynomial);
  const double step = largest_of(direction), start = largest_of(origin);
  const double a = quadric.second(direction), a_off = kTermRounding * second * step * step;
  // Every comparison is false for numbers that overflowed.
  if (!(std::abs(a) > kClear * a_off)) return false;
  if (starts_on_surface) {
    const double b = 0.5 * direction.dot(quadric.gradient(origin));
    if (!(std::abs(b) > kClear * kTermRounding * (2 * second * start + first) * step)) return false;
    if (const double t = -2 * b / a; t > 0) found.add(t, kSide);
    found.ends_inside = a < 0;
    return true;
  }
  const double foot_t = -origin.dot(direction) / direction.dot(direction);
  const Vec3 foot = origin + direction * foot_t;
  const double r = largest_of(foot), slope = 2 * second * r + first;
  const double b = 0.5 * direction.dot(quadric.gradient(foot)), b_off = kTermRounding * (slope + second * start) * step;
  const double c = quadric.value(foot);
  const double c_off = kTermRounding * ((second * r + first) * r + constant + slope * start);
  const double discriminant = b * b - a * c;
  const double off = 2 * std::abs(b) * b_off + std::abs(a) * c_off + std::abs(c) * a_off +
                     kTermRounding * (b * b + std::abs(a * c)) + b_off * b_off + a_off * c_off;
  if (discriminant < -off) {
    found.ends_inside = a < 0;
    return true;
  }
  if (!(discriminant > kClear * off)) return false;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double s1 = q / a, s2 = c / q;
  const double near = std::min(s1, s2), far = std::max(s1, s2);
  // A crossing this close to the start may lie before or behind it: the general method decides.
  const double doubt = kClear * kTermRounding * (std::abs(foot_t) + std::max(std::abs(near), std::abs(far)));
  const double t_near = foot_t + near, t_far = foot_t + far;
  if (!(std::abs(t_near) > doubt && std::abs(t_far) > doubt)) return false;
  if (t_near > 0) found.add(t_near, kSide);
  if (t_far > 0) found.add(t_far, kSide);
  found.ends_inside = a < 0;
  return true;
}

}  // namespace isl::render
