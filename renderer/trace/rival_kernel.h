// The inner loops of the rival solvers, for comparison with the product's. See rival_kernel.cpp.
#pragma once

#include "renderer/trace/trace_kernel.h"

#include <string>

namespace isl::render {

/// For solvers of which is_rival says so; else as trace_kernel.
[[nodiscard]] const TraceLoops* rival_kernel(const std::string& target);

}  // namespace isl::render
