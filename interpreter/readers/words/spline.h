// `spline { … }`, and the words that name its kinds.
#pragma once

#include "interpreter/element_stream.h"

#include <memory>
#include <optional>

namespace isl::interpreter {

/// Takes the next element if it is `linear_spline`, `quadratic_spline`, `cubic_spline` or `natural_spline`.
[[nodiscard]] std::optional<scene::SplineKind> accept_spline_kind(ElementStream& stream);

/// Reads the whole block: an identifier of a spline to start from, a kind (linear), then parameters with their values.
/// Values may be numbers or vectors; the longest decides how many terms the spline has.
[[nodiscard]] std::shared_ptr<const scene::Spline> read_spline(Context& context, const Element& block);

}  // namespace isl::interpreter
