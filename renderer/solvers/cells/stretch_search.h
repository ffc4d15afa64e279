// The questions of extended_search.h, asked in one type of extended numbers. The source is compiled once for each of
// the two types (renderer/extended/real.h), and each has these functions in its namespace. An answer is open once the
// ray's steps are spent.
#pragma once

#include "renderer/solvers/cells/extended_search.h"

#include <optional>

namespace isl::extended {

/// In long double.
[[nodiscard]] render::ExtendedAnswer search_stretch(const render::LaidOutFields& fields,
                                                    const render::OpenStretch& stretch, render::RaySteps& steps);
/// True if F > T at t, false if F < T; nothing if rounding hides which.
[[nodiscard]] std::optional<bool> is_inside_at(const render::LaidOutFields& fields, double t, render::RaySteps& steps);
/// True unless it is certain that F has the same sign all along the ray from t0 to t1.
[[nodiscard]] bool may_cross_on(const render::LaidOutFields& fields, double t0, double t1, render::RaySteps& steps);

}  // namespace isl::extended

namespace isl::wide_extended {

/// With 113 bits. On machines without such numbers the answer is never certain (no_wide_stretch_search.cpp).
[[nodiscard]] render::ExtendedAnswer search_stretch(const render::LaidOutFields& fields,
                                                    const render::OpenStretch& stretch, render::RaySteps& steps);
[[nodiscard]] std::optional<bool> is_inside_at(const render::LaidOutFields& fields, double t, render::RaySteps& steps);

}  // namespace isl::wide_extended
