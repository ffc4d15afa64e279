// φ(q) of one kernel (if convolved: of a plane or an infinite line) as docs/language.md defines it, q being the squared
// distance over the squared radius. Knows nothing of skeletons or space.
//
// For every kernel φ is convex and falls to φ = φ′ = 0 at the end of its support, q = Q, from where on it is zero. φ″
// falls too, except where the two pieces of the metaball meet.
#pragma once

#include "renderer/reference/jet.h"
#include "renderer/scene/database.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace isl::ISL_REFERENCE {

/// φ of a function q, where q may reach beyond Q.
using Profile = std::function<Jet(const Jet& q)>;

class ReferenceKernel {
 public:
  /// Precondition: only a quartic has the `support` meaning.
  explicit ReferenceKernel(const scene::Kernel& kernel);

  /// Q, beyond which φ = 0.
  [[nodiscard]] const Interval& support() const { return support_; }

  /// φ of q ≥ 0.
  [[nodiscard]] Jet of(const Jet& q) const;

  /// φ, φ′ and φ″ over a range of q.
  [[nodiscard]] Jet over(const Interval& q) const;
  /// No more than the least φ over a range of q. An interval that reaches from 1 to e⁵⁰⁰ has lost the digits of its
  /// lower end; these are not.
  [[nodiscard]] Real least(const Interval& q) const { return std::max(over(q.hi()).value.lo(), Real(0)); }
  [[nodiscard]] Real value(Real q) const { return over(q).value.middle(); }
  [[nodiscard]] Real slope(Real q) const { return over(q).slope.middle(); }

 private:
  [[nodiscard]] Jet at(const Interval& q) const { return profile_({q, 1, 0}); }

  Profile profile_;
  Interval support_;
  std::optional<Interval> junction_;  ///< where φ″ jumps within the support
};

}  // namespace isl::ISL_REFERENCE
