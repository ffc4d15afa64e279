// F along one ray: the components that it can meet, and enclosures of F and F′ = dF/dt over a stretch of it. It stands
// between reference_field and reference_tracer; it must not know how roots are searched.
//
// Enclosures: at a single t everything is interval arithmetic on one number, a value with its rounding error. Over [t0,
// t1] a component's q is enclosed from its values and slopes at both ends, by reference_skeleton. φ and φ′ are
// monotone, so their ranges are exact. (A convolved curve has enclosures of its own.) The sum is then sharpened by the
// mean-value form F(t0) + F′([t0, t1])·(t − t0) from either end, which makes the enclosure converge quadratically.
#pragma once

#include "renderer/reference/reference_field.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isl::ISL_REFERENCE {

class FieldOnRay {
 public:
  /// Indices of components that may matter, in no special order.
  using Active = std::vector<std::uint32_t>;

  FieldOnRay(const ReferenceField& field, const FieldRay& ray);

  /// Outside [begin, end] no component changes, and only half-spaces have a value; begin > end if the ray meets no
  /// support.
  [[nodiscard]] Real begin() const { return begin_; }
  [[nodiscard]] Real end() const { return end_; }

  /// True if it is certain that F is in `band` on all of [t0, t1].
  [[nodiscard]] bool stays_within(const Interval& band, Real t0, Real t1) const;

  [[nodiscard]] Real threshold() const { return threshold_.middle(); }
  /// Searches the level set F = offset instead of F = 0.
  void raise_threshold(Real offset) { threshold_ = threshold_ + Interval(offset); }

  /// All components whose support the ray may meet.
  [[nodiscard]] Active all() const;
  /// The components of `from` whose support may meet [t0, t1].
  [[nodiscard]] Active active(const Active& from, Real t0, Real t1) const;

  /// F and F′ at t, with their rounding errors.
  [[nodiscard]] FieldRange at(const Active& active, Real t) const;
  /// F and F′ over [t0, t1].
  [[nodiscard]] FieldRange over(const Active& active, Real t0, Real t1) const;

  /// All active components at one t, in their order.
  using Samples = std::vector<ReferenceComponent::AtPoint>;
  /// A stretch of the ray with the components that may matter on it, and these at its ends, so that dividing it
  /// evaluates every place once.
  struct Piece {
    Real t0 = 0, t1 = 0;
    Active active;
    Samples first, last;
  };
  [[nodiscard]] Piece piece(const Active& from, Real t0, Real t1) const;
  /// F and F′ over the piece. Components that are zero on all of it are taken out of it.
  [[nodiscard]] FieldRange over(Piece& piece) const;
  /// F and F′ at t, and all active components there.
  [[nodiscard]] FieldRange at(const Active& active, Real t, Samples& samples) const;

  /// The sizes at t from which a computation in double precision gets its rounding error.
  struct Magnitude {
    Real values = 0;         ///< Σ|fᵢ|
    Real gradients = 0;      ///< Σ|∇fᵢ||D|: the effect of a change of place, in any direction. A product with a
                             ///< normal is rounded by the lengths in it, however small the result is.
    Real sensitivities = 0;  ///< Σ|q·dfᵢ/dq|: the effect of a relative error of q
    std::size_t count = 0;   ///< number of components that are not zero
  };
  [[nodiscard]] Magnitude magnitude_at(Real t) const;

 private:
  struct Support {
    Real begin, end;
  };
  /// One component with the ray in the component's own space. Outside `support` its value is zero.
  struct Part {
    const ReferenceComponent* component;
    std::uint32_t branch;
    Line line;
    Support support;
  };

  using Sums = std::vector<FieldRange>;  ///< one for each branch
  /// A maximum in which rivals without a component on the ray, if there are any, are one rival of zero.
  struct MaximumHere {
    Maximum maximum;
    bool has_idle;
  };

  void find_maxima(const ReferenceField& field);
  void add(Sums& sums, const Part& part, const FieldRange& range) const;
  [[nodiscard]] FieldRange total(Sums& sums) const;
  [[nodiscard]] static std::optional<Support> support_on(const ReferenceComponent& component, const Line& line);

  FieldRay ray_;
  std::vector<Part> parts_;
  std::vector<MaximumHere> maxima_;
  std::size_t branch_count_ = 1;  ///< of the branches that have a component on the ray, or another branch with one
  bool is_unblended_;
  Interval threshold_;
  mutable Sums sums_, firsts_, lasts_;  ///< kept, so that an evaluation allocates nothing
  Real begin_ = 0, end_ = -1;
};

}  // namespace isl::ISL_REFERENCE
