// The curves of convolutions, used by reference_convolution.
#pragma once

#include "renderer/reference/reference_convolution.h"

#include <memory>

namespace isl::ISL_REFERENCE {

/// The segment from a to b, scaled by `unit`.
[[nodiscard]] std::shared_ptr<const Curve> segment_curve(const scene::Component& component, Real unit);
/// The circle about a and the axis b, scaled by `unit`.
[[nodiscard]] std::shared_ptr<const Curve> circle_curve(const scene::Component& component, Real unit);

}  // namespace isl::ISL_REFERENCE
