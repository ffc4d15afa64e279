// The inner loops of the rival solvers, which are compared with the product's. They are a module of their own
// (renderer/rivals), loaded when one of them is named first: they take as long to compile as the product's, and few
// pictures need them.
#pragma once

#include "renderer/trace/trace_entry_points.h"

#include <string>

namespace isl::render {

/// The rivals' loops for the vector target named as trace_entry_points() has it; or the reason why there are none
/// (lower case, no full stop), and what to do.
struct RivalLoops {
  const TraceLoops* loops = nullptr;
  std::string error;
  std::string hint = "the rival solvers are a module of their own, made by the build's target `isl_rivals`";
};
[[nodiscard]] RivalLoops rival_loops(const std::string& target);

}  // namespace isl::render

extern "C" {
/// The two functions of the module. The stamp stands for the program's headers, on which the layout of all that both
/// sides share depends: a module with another stamp is not used.
const char* isl_rivals_stamp();
const isl::render::TraceLoops* isl_rivals_loops(const char* target);
}
