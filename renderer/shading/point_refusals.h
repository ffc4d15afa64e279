// Tells that the patterns at one point, or its place in the objects, took more steps or memory than the run allows,
// which ends a rendering.
#pragma once

#include "base/run_limits.h"
#include "renderer/scene/refusal.h"

#include <fmt/format.h>

#include <string_view>

namespace isl::render {

/// The first refusal of a rendering; any thread may call the members.
class PointRefusals {
 public:
  explicit PointRefusals(const RunLimits& run) : run_(run) {}

  /// Called when the colours at a point could not be found. `thing`, made at `origin`, has the patterns: "this object".
  /// A run that is stopped is no refusal.
  void report(std::string_view thing, OriginId origin) {
    if (isl::is_set(run_.stop)) return;
    first_.report({fmt::format("the textures of {} take more than {:g} steps at a point, or more memory than is left",
                               thing, static_cast<double>(run_.steps_at_point)),
                   "`--max-turns` and `--max-memory` raise the limits", origin});
  }
  /// Called when something that pictures need cannot be made.
  void report(const scene::Refusal& refusal) {
    if (!isl::is_set(run_.stop)) first_.report(refusal);
  }
  /// Called when the steps did not suffice to find whether the camera is in an object.
  void report_camera() {
    if (isl::is_set(run_.stop)) return;
    first_.report({fmt::format("the objects have parts that take more than {:g} steps to ask whether the camera is in "
                               "one of them",
                               static_cast<double>(run_.steps_at_point)),
                   "`--max-turns` raises the limit",
                   {}});
  }
  /// True if the rest of the rendering is in vain.
  [[nodiscard]] bool is_set() const noexcept { return first_.is_set(); }
  [[nodiscard]] const std::optional<scene::Refusal>& refusal() const { return first_.refusal(); }

 private:
  RunLimits run_;
  scene::FirstRefusal first_;
};

}  // namespace isl::render
