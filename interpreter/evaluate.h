// The interpreter's entry: a parsed scene in, the primitive database out. All validation of what the user wrote that is
// not syntax happens behind this function; the renderer sees only the database.
#pragma once

#include "base/diagnostic.h"
#include "grammar/ast.h"
#include "grammar/loader.h"
#include "grammar/symbols.h"
#include "interpreter/origin_table.h"
#include "renderer/scene/database.h"
#include "renderer/scene/queries.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace isl::interpreter {

/// What bounds a runaway script. Exceeding one is an error that names the option and ends the evaluation.
struct Limits {
  std::size_t max_depth = 1000;                         ///< macro calls and nested objects in progress at once
  double max_turns = 1e9;                               ///< of all loops together, and macro calls
  double max_primitives = 1e7;                          ///< blob components, solids, groups and lights
  std::size_t max_memory_bytes = std::size_t{4} << 30;  ///< of what the scene holds, roughly
  std::size_t max_include_depth = 32;
};

struct EvaluateOptions {
  Limits limits;
  /// `-D NAME=VALUE`, bound before the first line.
  std::vector<std::pair<std::string, std::variant<double, std::string>>> defines;
  /// What is not supported is skipped with a warning instead of an error.
  bool lenient = false;
  double clock = 0;
  bool clock_on = false;  ///< a clock or frame was asked for
  int frame = 0;          ///< 0: no animation
  int image_width = 800, image_height = 600;
  bool is_size_known = false;  ///< the picture will have this size: a camera that does not fit it is warned of
  /// Receives the text of each #debug; may be empty.
  std::function<void(std::string_view)> print_debug;
  /// Answers `trace`, `inside`, `min_extent` and `max_extent`; where it is null they are errors.
  scene::Queries* queries = nullptr;
  /// Looked at now and then; where it turns true the evaluation ends with an error. May be null.
  const std::atomic<bool>* stop = nullptr;
};

struct EvaluatedScene {
  scene::Database database;
  OriginTable origins;
};

/// Executes `unit`. User errors go to `sink`; where there is one, the database holds what could be read but is not to
/// be rendered. Never throws for what a scene does.
[[nodiscard]] EvaluatedScene evaluate(grammar::Loader& loader, grammar::SymbolTable& symbols, const grammar::Unit& unit,
                                      const EvaluateOptions& options, DiagnosticSink& sink);

}  // namespace isl::interpreter
