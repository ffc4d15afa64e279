// The interpreter's entry: a parsed scene in, the primitive database out. All validation of the user's text beyond
// syntax happens behind this function; the renderer sees only the database.
#pragma once

#include "base/diagnostic.h"
#include "base/run_limits.h"
#include "grammar/ast.h"
#include "grammar/loader.h"
#include "grammar/symbols.h"
#include "interpreter/origin_table.h"
#include "renderer/patterns/kinds/sampled_image.h"
#include "renderer/scene/database.h"
#include "renderer/scene/queries.h"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace isl::interpreter {

/// Limits that stop a runaway script. Exceeding one is an error that names the option and ends the evaluation.
struct Limits {
  std::size_t max_depth = 1000;                         ///< macro calls and nested objects in progress at once
  double max_turns = 1e9;                               ///< turns of all loops together, and macro calls
  double max_primitives = 1e7;                          ///< blob components, solids, groups and lights
  std::size_t max_memory_bytes = std::size_t{4} << 30;  ///< approximate size of the scene
  std::size_t max_include_depth = 32;
  std::size_t max_files = 1000;                         ///< that the scene writes
  std::size_t max_debug_bytes = std::size_t{16} << 20;  ///< of all texts of #debug
};

struct EvaluateOptions {
  Limits limits;
  /// `-D NAME=VALUE`, bound before the first line.
  std::vector<std::pair<std::string, std::variant<double, std::string>>> defines;
  /// Skips unsupported features with a warning instead of an error.
  bool lenient = false;
  double clock = 0;
  bool clock_on = false;  ///< the user set a clock or frame
  int frame = 0;          ///< 0: no animation
  int image_width = 800, image_height = 600;
  bool is_size_known = false;  ///< the picture will have this size: a camera with another ratio causes a warning
  /// Receives the text of each #debug; may be empty.
  std::function<void(std::string_view)> print_debug;
  /// Answers `trace`, `inside`, `min_extent` and `max_extent`; if it is null they are errors.
  scene::Queries* queries = nullptr;
  /// Prepares the images of functions that the scene calls; if it is null, such calls are errors.
  render::ImageSource* images = nullptr;
  /// When its flag is set, the evaluation ends with an error. Its budget is charged with all that `limits` counts; if
  /// there is none, evaluate() makes one of limits.max_memory_bytes. Its steps are those of `limits`.
  RunLimits run;
};

/// The steps that patterns and functions may take at one point.
[[nodiscard]] std::uint64_t steps_at_point(const Limits& limits);

struct EvaluatedScene {
  scene::Database database;
  OriginTable origins;
  Charge charge;  ///< of both, if EvaluateOptions::run has a budget
};

/// Executes `unit`. User errors go to `sink`; if there is one, the database holds all that could be read but must not
/// be rendered. No mistake in a scene makes it throw.
[[nodiscard]] EvaluatedScene evaluate(grammar::Loader& loader, grammar::SymbolTable& symbols, const grammar::Unit& unit,
                                      const EvaluateOptions& options, DiagnosticSink& sink);

}  // namespace isl::interpreter
