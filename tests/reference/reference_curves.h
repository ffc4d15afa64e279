// The curves of convolutions. Behind reference_convolution.
#pragma once

#include "tests/reference/reference_convolution.h"

#include <memory>

namespace isl::reference {

/// From a to b, times `unit`.
[[nodiscard]] std::shared_ptr<const Curve> segment_curve(const scene::Component& component, long double unit);
/// The circle about a and the axis b, times `unit`.
[[nodiscard]] std::shared_ptr<const Curve> circle_curve(const scene::Component& component, long double unit);

}  // namespace isl::reference
