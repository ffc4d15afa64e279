// Cauchy's kernel k(q) = 1/(1 + σ²q)² minus its tangent at q = Q, divided by the value of that at q = 1; σ and Q follow
// from φ′(1) = −h and φ(0) = eʰ.
//
// Let s = (1 + σ²q)/(1 + σ²) = c + (1 − c)q, so that c = 1/(1 + σ²) and s are in (0, 1] up to q = 1, where s = 1, and
// let s = 1 + e at q = Q. The difference from the tangent has a double root there, and factors:
//   φ = ((1 + e − s)/e)²·(1 + e + 2s)/((3 + e)s²)
//   φ′ = −2(1 − c)(1 + e − s)((1 + e)² + (1 + e)s + s²)/(e²(3 + e)s³)
// φ′(1) = −h: with r = 2(1 − c)/h, the condition r = e(3 + e)/(e(3 + e) + 3) is a quadratic in e, so
//   e = 2m/(3 + √(9 + 4m)),   m = 3r/(1 − r),   Q = 1 + e/(1 − c).
// φ(0) = eʰ is then one equation for λ = −ln c,
//   2λ + 2 ln(1 + (1 − c)/e) + ln(1 − 2(1 − c)/(3 + e)) = h.
// As λ → 0 its left side tends to 2 ln(1 + h/2) < h, and at λ = h/2 it exceeds h, since (1 + e − s)²(1 + e + 2s) falls
// with s; it rises between. λ rather than σ, which is 10⁵³ at h = 500: c and 1 − c then have all their digits.
//
// A plane convolved with k minus its tangent: ∫k(q + u)du is 1/(1 + σ²q) up to a factor, and the subtracted part is the
// parabola that touches it at Q. The difference has a triple root there:
//   φ = ((1 + e − s)/e)³/s,   φ′ = −(1 − c)(1 + e − s)²(1 + e + 2s)/(e³s²).
// φ′(1) = −h is (1 − c)(1 + 3/e) = h: e = 3(1 − c)/(h − 1 + c); and φ(0) = eʰ is λ + 3 ln(1 + (h − 1 + c)/3) = h. The
// left side is 3 ln(1 + h/3) < h at λ = 0, more than h at λ = h, and rises by 1 − 3c/(2 + h + c) > 0.
#include "renderer/reference/kernel_forms.h"

namespace isl::ISL_REFERENCE {
namespace {

/// Applies a rising function of the library to an interval.
template <class Function>
Interval rising(const Function& f, const Interval& x) {
  return widened(f(x.lo), f(x.hi), kLibraryError);
}

Interval log_of_one_plus(const Interval& x) {
  return rising([](Real one) { return log1p(one); }, x);
}

/// The constants that one λ and φ′(1) = −h determine.
struct Constants {
  Interval c, rest;  ///< c and 1 − c
  Interval e;

  Constants(const Interval& lambda, const Interval& h)
      : c(rising([](Real x) { return exp(x); }, -lambda)), rest(-rising([](Real x) { return expm1(x); }, -lambda)) {
    const Interval r = Interval(2) * rest / h;
    const Interval m = Interval(3) * r / (Interval(1) - r);
    e = Interval(2) * m / (Interval(3) + square_root(Interval(9) + Interval(4) * m));
  }
};

/// ln φ(0) − h.
Interval excess_in_the_middle(const Interval& lambda, const Interval& h) {
  const Constants k(lambda, h);
  return Interval(2) * (lambda + log_of_one_plus(k.rest / k.e)) +
         log_of_one_plus(-(Interval(2) * k.rest / (Interval(3) + k.e))) - h;
}

/// Bisects to neighbouring numbers: the last place, seen from `from`, where a function certainly has this sign.
template <class Function>
Real last_certain(const Function& f, Real from, Real to, int sign) {
  while (true) {
    const Real middle = from + (to - from) / 2;
    if (middle == from || middle == to) return from;
    (f(middle).sign() == sign ? from : to) = middle;
  }
}

/// The place between 0 and `most` where a rising function passes zero.
template <class Function>
Interval zero_of(const Function& f, Real most) {
  return {last_certain(f, 0, most, -1), last_certain(f, most, 0, 1)};
}

Interval solved_lambda(const Interval& h) {
  return zero_of([&](Real lambda) { return excess_in_the_middle(lambda, h); }, h.hi / 2);
}

class CauchyForm final : public KernelForm {
 public:
  explicit CauchyForm(const scene::Kernel& kernel) : k_(solved_lambda(kernel.hardness), kernel.hardness) {}

  [[nodiscard]] Interval support() const override { return Interval(1) + k_.e / k_.rest; }
  [[nodiscard]] Interval value(Real q) const override {
    const Interval s = s_at(q);
    return square(to_border(q) / k_.e) * (border() + Interval(2) * s) / ((Interval(2) + border()) * square(s));
  }
  [[nodiscard]] Interval slope(Real q) const override {
    const Interval s = s_at(q);
    const Interval squares = square(border()) + border() * s + square(s);
    return -(Interval(2) * k_.rest * to_border(q) * squares /
             (square(k_.e) * (Interval(2) + border()) * square(s) * s));
  }

 private:
  [[nodiscard]] Interval s_at(Real q) const { return k_.c + k_.rest * Interval(q); }
  /// s at the border of the support, and the distance of s from it.
  [[nodiscard]] Interval border() const { return Interval(1) + k_.e; }
  [[nodiscard]] Interval to_border(Real q) const { return Depth{k_.e, k_.rest}.at(q); }

  Constants k_;
};

class CauchySheetForm final : public KernelForm {
 public:
  explicit CauchySheetForm(const scene::Kernel& kernel) {
    const Interval h(kernel.hardness);
    const auto c_of = [](const Interval& lambda) { return rising([](Real x) { return exp(x); }, -lambda); };
    const auto rest_of = [](const Interval& lambda) { return -rising([](Real x) { return expm1(x); }, -lambda); };
    const Interval lambda = zero_of(
        [&](Real at) { return Interval(at) + Interval(3) * log_of_one_plus((h - rest_of(at)) / Interval(3)) - h; },
        h.hi);
    c_ = c_of(lambda);
    rest_ = rest_of(lambda);
    e_ = Interval(3) * rest_ / (h - rest_);
  }

  [[nodiscard]] Interval support() const override { return Interval(1) + e_ / rest_; }
  [[nodiscard]] Interval value(Real q) const override {
    const Interval depth = Depth{e_, rest_}.at(q) / e_;
    return square(depth) * depth / s_at(q);
  }
  [[nodiscard]] Interval slope(Real q) const override {
    const Interval depth = Depth{e_, rest_}.at(q) / e_, s = s_at(q);
    return -(rest_ * square(depth) * (Interval(1) + e_ + Interval(2) * s) / (e_ * square(s)));
  }

 private:
  [[nodiscard]] Interval s_at(Real q) const { return c_ + rest_ * Interval(q); }

  Interval c_, rest_;  ///< c and 1 − c
  Interval e_;
};

}  // namespace

KernelFormHandle cauchy_form(const scene::Kernel& kernel) { return std::make_shared<CauchyForm>(kernel); }
KernelFormHandle cauchy_sheet_form(const scene::Kernel& kernel) { return std::make_shared<CauchySheetForm>(kernel); }

}  // namespace isl::ISL_REFERENCE
