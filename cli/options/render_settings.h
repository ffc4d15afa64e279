// The settings of a picture: the command line's options, else the scene's global_settings, else defaults.
#pragma once

#include "cli/options/options.h"
#include "renderer/render.h"
#include "renderer/scene/database.h"
#include "renderer/trace/tracer.h"

#include <string>

namespace isl::cli {

struct RenderSettings {
  SolverChoice solver;
  render::Tolerance tolerance;
  std::string tolerance_text;  ///< for messages; for `exact` its effective value
  render::TracerOptions tracer;
  render::RenderOptions render;  ///< except `progress` and `stop`
};

/// Precondition: the scene's settings have been checked (Session::evaluate).
[[nodiscard]] RenderSettings render_settings(const RenderCommand& command, const scene::Database& database);

/// The options that decide the picture, as a user would write them, in one fixed order and with every default spelt
/// out: the same text means the same picture of the same scene. Never threads, places or times.
[[nodiscard]] std::string canonical_options(const RenderCommand& command, const RenderSettings& settings);

}  // namespace isl::cli
