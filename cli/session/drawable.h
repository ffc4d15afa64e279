// The step between evaluating and rendering: a feature that the renderer cannot draw yet is an error, or with --lenient
// left out with a warning. Every command that renders, or tells whether a scene can be rendered, uses it.
#pragma once

#include "cli/session/session.h"
#include "renderer/scene/database.h"

#include <optional>

namespace isl::cli {

class DrawableScene {
 public:
  /// Reports to the session's sink the features that cannot be drawn, each kind once, at its first place. Precondition:
  /// the session was evaluated.
  DrawableScene(Session& session, int quality);

  /// True if errors were reported: there is nothing to render.
  [[nodiscard]] bool is_refused() const { return is_refused_; }
  /// The drawable part of the scene; precondition: it is not refused.
  [[nodiscard]] const scene::Database& database() const { return reduced_ ? *reduced_ : whole_; }

 private:
  const scene::Database& whole_;
  std::optional<scene::Database> reduced_;  ///< a copy without the features that cannot be drawn, if there are any
  Charge copied_;                           ///< its memory
  bool is_refused_ = false;
};

}  // namespace isl::cli
