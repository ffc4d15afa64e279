// The questions of extended_search.h, asked of the reference. The source is compiled once for each of its two types of
// numbers (renderer/reference/real.h), and each has these functions in its namespace.
#pragma once

#include "renderer/solvers/cells/extended_search.h"

#include <optional>

namespace isl::reference {

/// In long double.
[[nodiscard]] render::ExtendedAnswer search_stretch(const render::LaidOutFields& fields,
                                                    const render::OpenStretch& stretch);
/// True if F > T at t, false if F < T; nothing if rounding hides which.
[[nodiscard]] std::optional<bool> is_inside_at(const render::LaidOutFields& fields, double t);
/// True unless it is certain that F has the same sign all along the ray from t0 to t1.
[[nodiscard]] bool may_cross_on(const render::LaidOutFields& fields, double t0, double t1);

}  // namespace isl::reference

namespace isl::wide_reference {

/// With 113 bits. On machines without such numbers the answer is never certain (no_wide_stretch_search.cpp).
[[nodiscard]] render::ExtendedAnswer search_stretch(const render::LaidOutFields& fields,
                                                    const render::OpenStretch& stretch);
[[nodiscard]] std::optional<bool> is_inside_at(const render::LaidOutFields& fields, double t);

}  // namespace isl::wide_reference
