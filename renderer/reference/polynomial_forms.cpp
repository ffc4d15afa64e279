// Kernels that are polynomials in the squared distance or, for the metaball's shell, in the distance. With h the
// hardness, x = q/Q and φ = w(x)/w(1/Q), the condition φ′(1) = −h reads −x·w′/w = h at x = 1/Q; each has a closed
// solution.
#include "renderer/reference/kernel_forms.h"

namespace isl::ISL_REFERENCE {
namespace {

/// w = (1 − x)²:   surface: φ = (1 + (h/2)(1 − q))²,   Q = 1 + 2/h.
///                 support: φ = (1 − q)²,              Q = 1          (POV-Ray's own component)
class QuarticForm final : public KernelForm {
 public:
  explicit QuarticForm(const scene::Kernel& kernel) {
    if (kernel.meaning == scene::RadiusMeaning::support) {
      support_ = 1;
      depth_ = {0, 1};
    } else {
      support_ = Interval(1) + Interval(2) / Interval(kernel.hardness);
      depth_ = {1, Interval(kernel.hardness) * Interval(0.5L)};
    }
  }
  [[nodiscard]] Interval support() const override { return support_; }
  [[nodiscard]] Interval value(Real q) const override { return square(depth_.at(q)); }
  [[nodiscard]] Interval slope(Real q) const override { return -(Interval(2) * depth_.rate * depth_.at(q)); }

 private:
  Interval support_;
  Depth depth_;  ///< √φ
};

/// w = (1 − x)³, also the kernel of a plane convolved with (1 − x)²: φ = (1 + (h/3)(1 − q))³, Q = 1 + 3/h.
class CubicForm final : public KernelForm {
 public:
  explicit CubicForm(const scene::Kernel& kernel)
      : support_(Interval(1) + Interval(3) / Interval(kernel.hardness)),
        depth_{1, Interval(kernel.hardness) / Interval(3)} {}
  [[nodiscard]] Interval support() const override { return support_; }
  [[nodiscard]] Interval value(Real q) const override { return square(depth_.at(q)) * depth_.at(q); }
  [[nodiscard]] Interval slope(Real q) const override { return -(Interval(3) * depth_.rate * square(depth_.at(q))); }

 private:
  Interval support_;
  Depth depth_;  ///< the cube root of φ
};

/// Wyvill's kernel: w = 1 − (22/9)x + (17/9)x² − (4/9)x³ = y²(5 + 4y)/9 with y = 1 − x. Then −w′ = 2y(5 + 6y)/9, and
/// the condition 2x(5 + 6y) = h·y(5 + 4y) is a quadratic,
///   (12 + 4h)x² − (22 + 13h)x + 9h = 0   or   (12 + 4h)y² + (5h − 2)y − 10 = 0,
/// whose roots in (0, 1), with the discriminant (5h + 14)² + 288 of both, are written so that nothing cancels.
class SoftForm final : public KernelForm {
 public:
  explicit SoftForm(const scene::Kernel& kernel) {
    const Interval h(kernel.hardness);
    const Interval root = square_root(square(Interval(5) * h + Interval(14)) + Interval(288));
    const Interval sum = Interval(22) + Interval(13) * h + root;
    support_ = sum / (Interval(18) * h);
    depth_ = {Interval(20) / (Interval(5) * h - Interval(2) + root), Interval(18) * h / sum};
    amplitude_ = Interval(1) / (square(depth_.at_one) * (Interval(5) + Interval(4) * depth_.at_one));
  }
  [[nodiscard]] Interval support() const override { return support_; }
  [[nodiscard]] Interval value(Real q) const override {
    const Interval y = depth_.at(q);
    return amplitude_ * square(y) * (Interval(5) + Interval(4) * y);
  }
  [[nodiscard]] Interval slope(Real q) const override {
    const Interval y = depth_.at(q);
    return -(Interval(2) * depth_.rate * amplitude_ * y * (Interval(5) + Interval(6) * y));
  }

 private:
  Interval support_;
  Depth depth_;  ///< y
  Interval amplitude_;
};

/// Nishimura's kernel: with ρ = √x, w = 1 − 3ρ² up to ρ = ⅓ and (3/2)(1 − ρ)² from there; w′ is continuous. In the
/// shell the condition is ρ/(1 − ρ) = h, so ρ = h/(1 + h) at q = 1, which is in the shell if h ≥ ½. Softer kernels have
/// q = 1 in the core: 3x/(1 − 3x) = h, so ρ² = h/(3(1 + h)) there.
class MetaballForm final : public KernelForm {
 public:
  explicit MetaballForm(const scene::Kernel& kernel) {
    const Interval h(kernel.hardness), above = Interval(1) + h;
    if (kernel.hardness > 0.5) {
      rho_ = h / above;
      shell_ = Interval(1) / above;
      amplitude_ = square(above) * (Interval(2) / Interval(3));
      support_ = square(above / h);
    } else {
      rho_ = square_root(h / (Interval(3) * above));
      shell_ = Interval(1) - rho_;
      amplitude_ = above;
      support_ = Interval(3) * above / h;
    }
  }
  [[nodiscard]] Interval support() const override { return support_; }
  [[nodiscard]] Interval value(Real q) const override {
    return piecewise(q, &MetaballForm::core_value, &MetaballForm::shell_value);
  }
  [[nodiscard]] Interval slope(Real q) const override {
    return piecewise(q, &MetaballForm::core_slope, &MetaballForm::shell_slope);
  }

 private:
  using Piece = Interval (MetaballForm::*)(Real q) const;

  /// The hull of both pieces if rounding leaves open which one applies.
  [[nodiscard]] Interval piecewise(Real q, Piece core, Piece shell) const {
    const Interval nine_x = Interval(9) * Interval(q) * square(rho_);
    if (nine_x.hi < 1) return (this->*core)(q);
    if (nine_x.lo > 1) return (this->*shell)(q);
    return hull((this->*core)(q), (this->*shell)(q));
  }

  [[nodiscard]] Interval core_value(Real q) const {
    return amplitude_ * (Interval(1) - Interval(3) * Interval(q) * square(rho_));
  }
  [[nodiscard]] Interval core_slope(Real) const { return -(Interval(3) * amplitude_ * square(rho_)); }

  /// 1 − ρ: 1 − √q is (1 − q)/(1 + √q), and ρ is √q times its value at 1.
  [[nodiscard]] Interval to_border(Real q) const { return Depth{shell_, rho_ / (Interval(1) + square_root(q))}.at(q); }
  [[nodiscard]] Interval shell_value(Real q) const { return Interval(1.5L) * amplitude_ * square(to_border(q)); }
  [[nodiscard]] Interval shell_slope(Real q) const {
    return -(Interval(1.5L) * amplitude_ * to_border(q) * rho_ / square_root(q));
  }

  Interval support_;
  Interval rho_, shell_;  ///< ρ and 1 − ρ at q = 1
  Interval amplitude_;    ///< φ(0)
};

}  // namespace

KernelFormHandle cubic_form(const scene::Kernel& kernel) { return std::make_shared<CubicForm>(kernel); }
KernelFormHandle quartic_form(const scene::Kernel& kernel) { return std::make_shared<QuarticForm>(kernel); }
KernelFormHandle soft_form(const scene::Kernel& kernel) { return std::make_shared<SoftForm>(kernel); }
KernelFormHandle metaball_form(const scene::Kernel& kernel) { return std::make_shared<MetaballForm>(kernel); }

}  // namespace isl::ISL_REFERENCE
