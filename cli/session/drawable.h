// Between evaluating and rendering: what the renderer cannot draw yet is an error, or with --lenient left out with a warning.
// Every command that renders, or tells whether a scene can be rendered, comes here.
#pragma once

#include "cli/session/session.h"
#include "renderer/scene/database.h"

#include <optional>

namespace isl::cli {

class DrawableScene {
 public:
  /// Tells the session's sink what cannot be drawn, each kind once, at its first place. Precondition: the session was
  /// evaluated.
  DrawableScene(Session& session, int quality);

  /// Errors were told: there is nothing to render.
  [[nodiscard]] bool is_refused() const { return is_refused_; }
  /// What can be drawn; precondition: it is not refused.
  [[nodiscard]] const scene::Database& database() const { return reduced_ ? *reduced_ : whole_; }

 private:
  const scene::Database& whole_;
  std::optional<scene::Database> reduced_;  ///< a copy without what cannot be drawn, where there is any
  bool is_refused_ = false;
};

}  // namespace isl::cli
