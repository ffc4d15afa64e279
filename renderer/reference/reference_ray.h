// F along one ray: the components that it can meet, and enclosures of F, F′ and F″ over a stretch of it. It stands
// between reference_field and reference_tracer; it must not know how roots are searched.
//
// Over a stretch every component is evaluated twice: at the middle, where only rounding is uncertain, and everywhere at
// once. The sums are made first and sharpened by Taylor's formula (jet.h) after, so that what cancels in the middle
// cancels in the enclosure too.
#pragma once

#include "renderer/reference/reference_field.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isl::ISL_REFERENCE {

class FieldOnRay {
 public:
  FieldOnRay(const ReferenceField& field, const Line& ray);

  /// Outside [begin, end] no component changes, and only half-spaces have a value; begin > end if the ray meets no
  /// support.
  [[nodiscard]] Real begin() const { return begin_; }
  [[nodiscard]] Real end() const { return end_; }

  [[nodiscard]] Real threshold() const { return threshold_.middle(); }
  /// Searches the level set F = offset instead of F = 0.
  void raise_threshold(Real offset) { threshold_ = threshold_ + Interval(offset); }

  /// F at t, with its rounding error.
  [[nodiscard]] Jet at(Real t) const { return at(all(), t); }
  /// F over [t0, t1].
  [[nodiscard]] Jet over(Real t0, Real t1) const;
  struct Band {
    Real low, high;
  };
  /// True if it is certain that F is in `band` on all of [t0, t1].
  [[nodiscard]] bool stays_within(const Band& band, Real t0, Real t1) const;

  /// Numbers of components that may matter, in no special order.
  using Active = std::vector<std::uint32_t>;
  [[nodiscard]] Active all() const;
  [[nodiscard]] Jet at(const Active& active, Real t) const;
  /// F over a stretch. Components that are zero on all of it are taken out of `active`.
  [[nodiscard]] JetPair on(Active& active, const LineStretch& stretch) const;

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
  /// One component with the ray in the component's own space. Outside `support` its value is zero.
  struct Part {
    const ReferenceComponent* component;
    std::uint32_t branch;
    Line line;
    ReferenceSkeleton::Stretch support;
  };
  /// A maximum in which rivals without a component on the ray, if there are any, are one rival of zero.
  struct MaximumHere {
    Maximum maximum;
    bool has_idle;
  };

  void find_maxima(const ReferenceField& field);
  [[nodiscard]] Jet total(std::vector<Jet>& sums) const;
  [[nodiscard]] Ends total(std::vector<Ends>& sums) const;

  Line ray_;
  std::vector<Part> parts_;
  std::vector<MaximumHere> maxima_;
  std::size_t branch_count_ = 1;  ///< of the branches that have a component on the ray, or another branch with one
  Interval threshold_;
  // Sums of branches, kept so that an evaluation allocates nothing.
  mutable std::vector<Jet> middles_, overs_;
  mutable std::vector<Ends> ends_;
  Real begin_ = 0, end_ = -1;
};

/// The stretch from t0 to t1.
[[nodiscard]] inline LineStretch stretch_between(Real t0, Real t1) {
  const Interval all(t0, t1);
  return {all.middle(), all.radius()};
}

}  // namespace isl::ISL_REFERENCE
