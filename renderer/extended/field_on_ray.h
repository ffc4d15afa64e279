// F along one ray, where F is the sum of some of a blob's components less its threshold: enclosures of F and F′ = dF/dt
// at a place and over a stretch. It stands between extended_component and root_search; it must not know how roots are
// searched.
//
// Enclosures: at a single t everything is interval arithmetic on one number, a value with its rounding error. Over [t0,
// t1] a component's q is enclosed from its values and slopes at both ends, by extended_skeleton. φ and φ′ are
// monotone, so their ranges are exact. (A convolved curve has enclosures of its own.) The sum is then sharpened by the
// mean-value form F(t0) + F′([t0, t1])·(t − t0) from either end, which makes the enclosure converge quadratically.
//
// Every component that is evaluated is a step of the ray's bound. Where that is spent, nothing is evaluated any more,
// and what is told of F is everything.
#pragma once

#include "renderer/extended/extended_component.h"
#include "renderer/rays/ray_steps.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace isl::ISL_EXTENDED {

class FieldOnRay {
 public:
  /// Indices of components that may matter, in no special order.
  using Active = std::vector<std::uint32_t>;

  /// The sum of the components whose numbers are given. The database and the counter must outlive it.
  FieldOnRay(const scene::Database& database, const scene::Blob& blob, std::span<const std::uint32_t> numbers,
             const Line& ray, render::RaySteps& steps);

  /// Outside [begin, end] no component changes, and only half-spaces have a value; begin > end if the ray meets no
  /// support.
  [[nodiscard]] Real begin() const { return begin_; }
  [[nodiscard]] Real end() const { return end_; }

  [[nodiscard]] Real threshold() const { return threshold_.middle(); }
  /// Searches the level set F = offset instead of F = 0.
  void raise_threshold(Real offset) { threshold_ = threshold_ + Interval(offset); }

  /// All components whose support the ray may meet.
  [[nodiscard]] Active all() const;

  /// F and F′ at t, with their rounding errors.
  [[nodiscard]] FieldRange at(const Active& active, Real t) const;
  /// F and F′ over [t0, t1].
  [[nodiscard]] FieldRange over(const Active& active, Real t0, Real t1) const;

  /// All active components at one t, in their order.
  using Samples = std::vector<ExtendedComponent::AtPoint>;
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

  /// True once the ray's bound is spent: the last answers are then everything.
  [[nodiscard]] bool is_spent() const { return steps_.is_spent(); }

 private:
  struct Support {
    Real begin, end;
  };
  /// One component with the ray in the component's own space. Outside `support` its value is zero.
  struct Part {
    ExtendedComponent component;
    Line line;
    Support support;
  };

  [[nodiscard]] static std::optional<Support> support_on(const ExtendedComponent& component, const Line& line);
  void add(const ExtendedComponent& component, const Line& ray);
  /// Counts the evaluation of some components; false if the bound is spent.
  [[nodiscard]] bool take(std::size_t components) const;

  std::vector<Part> parts_;
  Interval threshold_;
  Real begin_ = 0, end_ = -1;
  render::RaySteps& steps_;
};

}  // namespace isl::ISL_EXTENDED
