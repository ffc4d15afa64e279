// The questions of extended_search.h, asked in one type of extended numbers. The source is compiled once for each of
// the two types (renderer/extended/real.h), and each has these functions in its namespace. An answer is open once the
// ray's steps are spent.
#pragma once

#include "renderer/solvers/cells/extended_search.h"

#include <optional>
#include <vector>

namespace isl::render {

/// The answer of one type of extended numbers about a stretch. Lengths are measured from the start of the stretch,
/// because the answer is often more precise than doubles are at the ray's own t.
struct StretchAnswer {
  struct Part {
    long double begin, end;
  };
  bool is_open = true;  ///< nothing is known: the ray's steps are spent, or the side on which it starts is lost
  std::optional<long double> crossing;  ///< where the ray changes sides first, but for the doubts
  long double slack = 0;                ///< how far off it may be
  bool is_placed = true;                ///< that is no more than rounding, or no number of digits tells better
  std::optional<Part> bracket;          ///< the part around it on which F rises or falls strictly, if there is one
  /// Parts before the crossing where rounding hides the sign of F and that are longer than rounding moves the ray's own
  /// points, in order.
  std::vector<Part> doubts;

  [[nodiscard]] bool is_certain() const { return !is_open && doubts.empty() && is_placed; }
};

}  // namespace isl::render

namespace isl::extended {

/// In long double.
[[nodiscard]] render::StretchAnswer search_stretch(const render::LaidOutFields& fields,
                                                   const render::OpenStretch& stretch, render::RaySteps& steps);
/// True if F > T at t, false if F < T; nothing if rounding hides which.
[[nodiscard]] std::optional<bool> is_inside_at(const render::LaidOutFields& fields, double t, render::RaySteps& steps);
/// True unless it is certain that F has the same sign all along the ray from t0 to t1.
[[nodiscard]] bool may_cross_on(const render::LaidOutFields& fields, double t0, double t1, render::RaySteps& steps);
/// The crossing in the bracket of an answer, from the stretch's start on; nothing if the steps are spent.
[[nodiscard]] std::optional<long double> crossing_in(const render::LaidOutFields& fields,
                                                     const render::OpenStretch& stretch,
                                                     const render::StretchAnswer& known, render::RaySteps& steps);

}  // namespace isl::extended

namespace isl::wide_extended {

/// With 113 bits. On machines without such numbers the answer is open (no_wide_stretch_search.cpp).
[[nodiscard]] render::StretchAnswer search_stretch(const render::LaidOutFields& fields,
                                                   const render::OpenStretch& stretch, render::RaySteps& steps);
[[nodiscard]] std::optional<bool> is_inside_at(const render::LaidOutFields& fields, double t, render::RaySteps& steps);
[[nodiscard]] std::optional<long double> crossing_in(const render::LaidOutFields& fields,
                                                     const render::OpenStretch& stretch,
                                                     const render::StretchAnswer& known, render::RaySteps& steps);

}  // namespace isl::wide_extended
