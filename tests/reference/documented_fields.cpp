#include "tests/reference/documented_fields.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::documented {
namespace {

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(Real s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Real length2(const Vector& a) { return dot(a, a); }
Real length(const Vector& a) { return std::sqrt(length2(a)); }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real squared(Real x) { return x * x; }

/// The place at which a falling function becomes 0, by halving. It has no value at the lower end of a range, where a
/// border is infinite.
Real zero_of_falling(const std::function<Real(Real)>& f, Real low, Real high) {
  for (int i = 0; i < 90; ++i) {
    const Real middle = (low + high) / 2, value = f(middle);
    (value > 0 || !std::isfinite(value) ? low : high) = middle;
  }
  return low;
}

}  // namespace

Real sphere(const Vector& p, const Vector& c, Real r) { return length2(p - c) / squared(r); }

Real cylinder(const Vector& p, const Vector& c1, const Vector& c2, Real r) {
  const Vector o = p - c1, e = c2 - c1;
  const Real u = std::clamp(dot(o, e) / dot(e, e), Real(0), Real(1));
  return length2(o - u * e) / squared(r);
}

Real cone(const Vector& p, const Vector& c1, Real r1, const Vector& c2, Real r2) {
  const Vector o = p - c1, e = c2 - c1;
  const Real l = length(e), k = (r2 - r1) / l, x = dot(o, e) / l, rho2 = length2(o) - squared(x), w = r1 + k * x;
  const Real u = w > 0 ? std::clamp((x + k * rho2 / w) / l, Real(0), Real(1)) : r2 > r1 ? Real(1) : Real(0);
  return length2(o - u * e) / squared(r1 + u * (r2 - r1));
}

Real box(const Vector& p, const Vector& corner, const Vector& opposite, Real r) {
  Real sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Real l = std::min(corner[i], opposite[i]), h = std::max(corner[i], opposite[i]);
    sum += squared(std::max({l - p[i], p[i] - h, Real(0)}));
  }
  return sum / squared(r);
}

Real torus(const Vector& p, Real ring, Real r) {
  return (squared(std::hypot(p[0], p[2]) - ring) + squared(p[1])) / squared(r);
}

Real disc(const Vector& p, const Vector& c, const Vector& normal, Real ring, Real r) {
  const Vector n = (1 / length(normal)) * normal, o = p - c;
  const Real z = dot(o, n), rho = length(o - z * n);
  return (squared(std::max(rho - ring, Real(0))) + squared(z)) / squared(r);
}

Real triangle(const Vector& p, const Vector& c1, const Vector& c2, const Vector& c3, Real r) {
  const Vector n = cross(c2 - c1, c3 - c1);
  const auto is_inward = [&](const Vector& from, const Vector& to) { return dot(cross(to - from, p - from), n) >= 0; };
  if (is_inward(c1, c2) && is_inward(c2, c3) && is_inward(c3, c1))
    return squared(dot(p - c1, n)) / length2(n) / squared(r);
  return std::min({cylinder(p, c1, c2, r), cylinder(p, c2, c3, r), cylinder(p, c3, c1, r)});
}

Real plane(const Vector& p, const Vector& normal, Real d, Real r) {
  return squared(std::max(dot(normal, p) / length(normal) - d, Real(0))) / squared(r);
}

Real convolved_plane(const Vector& p, const Vector& normal, Real d, Real r) {
  return squared(dot(normal, p) / length(normal) - d) / squared(r);
}

// ---- Kernels --------------------------------------------------------------------------------------------------------

namespace {

Real cauchy_border(Real h, Real epsilon) {
  const Real t = 6 / (h * (1 + epsilon) - 2);
  return 1 + 2 * (1 + epsilon) * t / (std::sqrt(9 + 4 * t) + 3);
}

std::function<Real(Real)> cauchy_phi(Real epsilon, Real border_q) {
  return [=](Real q) {
    const Real b = epsilon + border_q;
    return squared(border_q - q) * (b + 2 * (epsilon + q)) / (squared(epsilon + q) * b * b * b);
  };
}

std::function<Real(Real)> plane_cauchy_phi(Real epsilon, Real border_q) {
  return [=](Real q) {
    const Real b = epsilon + border_q, d = border_q - q;
    return d * d * d / ((epsilon + q) * b * b * b);
  };
}

}  // namespace

CauchyConstants cauchy_constants(Real h) {
  const Real least = std::max(2 / h - 1, Real(0));
  const auto too_steep = [&](Real log_excess) {
    const Real epsilon = least + std::exp(log_excess);
    const std::function<Real(Real)> phi = cauchy_phi(epsilon, cauchy_border(h, epsilon));
    return std::log(phi(0) / phi(1)) - h;
  };
  const Real epsilon = least + std::exp(zero_of_falling(too_steep, -300, 300));
  return {epsilon, cauchy_border(h, epsilon)};
}

Kernel kernel(std::string_view name, Real h) {
  if (name.empty()) return {[](Real q) { return squared(1 - q); }, 1, 1};
  if (name == "quartic") {
    const Real border = 1 + 2 / h;
    return {[=](Real q) { return squared(1 - q / border); }, border, squared(1 + h / 2)};
  }
  if (name == "cubic") {
    const Real border = 1 + 3 / h;
    return {[=](Real q) { return std::pow(1 - q / border, Real(3)); }, border, std::pow(1 + h / 3, Real(3))};
  }
  if (name == "gaussian") {
    const Real delta = Real(1) / 1000, tail = delta * (1 + std::log(1 / delta));
    const Real g = h * (1 - tail) / (1 - delta), border = 1 + std::log(1 / delta) / g;
    return {[=](Real q) { return std::exp(g * (1 - q)) - delta * (1 + g * (border - q)); }, border, 1 / (1 - tail)};
  }
  Kernel result;
  if (name == "soft") {
    const Real a = 4 * h + 12, b = 13 * h + 22, c = 9 * h;
    const Real x = (b - std::sqrt(b * b - 4 * a * c)) / (2 * a);
    result.phi = [=](Real q) { return squared(1 - x * q) * (1 - 4 * x * q / 9); };
    result.border = 1 / x;
  } else if (name == "metaball") {
    const Real x = h >= 0.5L ? squared(h / (1 + h)) : h / (3 + 3 * h);
    result.phi = [=](Real q) {
      const Real v = x * q;
      return v <= Real(1) / 9 ? 1 - 3 * v : Real(1.5) * squared(1 - std::sqrt(v));
    };
    result.border = 1 / x;
  } else {
    const CauchyConstants constants = cauchy_constants(h);
    result.phi = cauchy_phi(constants.epsilon, constants.border);
    result.border = constants.border;
  }
  result.a = 1 / result.phi(1);
  return result;
}

Kernel plane_kernel(std::string_view name, Real h) {
  if (name == "quartic") return kernel("cubic", h);
  const Real least = std::max(1 / h - 1, Real(0));
  const auto border_of = [&](Real epsilon) { return 1 + 3 * (1 + epsilon) / (h * (1 + epsilon) - 1); };
  const auto too_steep = [&](Real log_excess) {
    const Real epsilon = least + std::exp(log_excess);
    const std::function<Real(Real)> phi = plane_cauchy_phi(epsilon, border_of(epsilon));
    return std::log(phi(0) / phi(1)) - h;
  };
  const Real epsilon = least + std::exp(zero_of_falling(too_steep, std::log(Real(1e-40L)), 100));
  Kernel result;
  result.border = border_of(epsilon);
  result.phi = plane_cauchy_phi(epsilon, result.border);
  result.a = 1 / result.phi(1);
  return result;
}

// ---- Convolved curves -----------------------------------------------------------------------------------------------

Convolution::Convolution(std::string_view name, Real h) : is_quartic_(name == "quartic") {
  if (is_quartic_) {
    support_ = std::sqrt(1 + 5 / (2 * h));
    a_ = Real(15) / 16 * std::pow(1 + 2 * h / 5, Real(2.5));
    return;
  }
  const auto too_steep = [&](Real log_epsilon) {
    epsilon_ = std::exp(log_epsilon);
    return std::log(line(0) / line(line_surface(h))) - h;
  };
  epsilon_ = std::exp(zero_of_falling(too_steep, std::log(Real(1e-40L)), 100));
  const Real y1 = line_surface(h);
  support_ = 1 / std::sqrt(y1);
  a_ = 1 / line(y1);
}

Real Convolution::line(Real y) const {
  const Real big_p = epsilon_ + y, w = std::sqrt(1 - y), b = epsilon_ + 1;
  return w / (big_p * b) + std::atan(w / std::sqrt(big_p)) / std::pow(big_p, Real(1.5)) - 2 * w / (b * b) -
         Real(8) / 3 * w * w * w / (b * b * b);
}

Real Convolution::line_slope(Real y) const {
  const Real big_p = epsilon_ + y, w = std::sqrt(1 - y), b = epsilon_ + 1;
  return -w / (big_p * b * b) - 3 * w / (2 * big_p * big_p * b) -
         Real(1.5) * std::atan(w / std::sqrt(big_p)) / std::pow(big_p, Real(2.5)) + 4 * w / (b * b * b);
}

Real Convolution::line_surface(Real h) const {
  const auto place = [](Real u) { return 1 / (1 + std::exp(-u)); };
  return place(zero_of_falling([&](Real u) { return h * line(place(u)) + place(u) * line_slope(place(u)); }, -140, 40));
}

Real Convolution::cylinder(const Vector& p, const Vector& c1, const Vector& c2, Real r) const {
  const Real rho = support_ * r;
  const Vector o = p - c1, e = c2 - c1;
  const Real x = dot(o, e) / length(e), y0 = length2(o - x / length(e) * e) / (rho * rho);
  if (!(y0 < 1)) return 0;
  const Real w2 = 1 - y0, w = std::sqrt(w2), big_p = epsilon_ + y0, b = epsilon_ + 1;
  const Real v1 = std::clamp(-x / rho, -w, w), v2 = std::clamp((length(e) - x) / rho, -w, w);
  const auto g = [&](Real v) {
    if (is_quartic_) return w2 * w2 * v - 2 * w2 * v * v * v / 3 + std::pow(v, Real(5)) / 5;
    return v / (2 * big_p * (big_p + v * v)) + std::atan(v / std::sqrt(big_p)) / (2 * std::pow(big_p, Real(1.5))) -
           v / (b * b) - 2 * (w2 * v - v * v * v / 3) / (b * b * b);
  };
  return a_ * (g(v2) - g(v1));
}

Real Convolution::torus(const Vector& p, Real ring, Real r) const {
  const Real rho = support_ * r, big_r = ring / rho;
  const Real beside = std::hypot(p[0], p[2]) / rho, above = p[1] / rho;
  const Real y0 = squared(beside - big_r) + squared(above), c = 2 * big_r * beside;
  if (!(y0 < 1)) return 0;
  constexpr Real kPi = std::numbers::pi_v<Real>;
  const Real mu = 1 - y0 >= 2 * c ? kPi : std::acos(1 - (1 - y0) / c);
  const Real k = 1 - y0 - c, j = 2 * (k * mu + c * std::sin(mu));
  if (is_quartic_) {
    return a_ * big_r * (2 * k * k * mu + 4 * k * c * std::sin(mu) + c * c * (mu + std::sin(mu) * std::cos(mu)));
  }
  const Real b = epsilon_ + 1, big_c = epsilon_ + y0 + c, d = big_c * big_c - c * c;
  const Real arc = mu == kPi ? 2 * kPi / std::sqrt(d)
                             : 4 / std::sqrt(d) * std::atan(std::sqrt((big_c + c) / (big_c - c)) * std::tan(mu / 2));
  return a_ * big_r *
         ((2 * c * std::sin(mu) / (big_c - c * std::cos(mu)) + big_c * arc) / d - 2 * mu / (b * b) -
          2 * j / (b * b * b));
}

}  // namespace isl::documented
