#include "interpreter/evaluate.h"

#include "interpreter/context.h"
#include "interpreter/deep_stack.h"
#include "interpreter/expressions.h"
#include "interpreter/files.h"
#include "interpreter/nesting.h"
#include "interpreter/prune.h"
#include "interpreter/readers/world/scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::interpreter {
namespace {

/// The language's version that `Isl` stands for; a scene asks `#ifdef (Isl)`.
constexpr double kIslVersion = 0.1;

void predeclare(Context& context, std::string_view name, Value value) {
  context.scopes.global(context.symbols.intern(name)).value = std::move(value);
}

void bind_predeclared(Context& context) {
  const EvaluateOptions& options = context.options;
  predeclare(context, "Isl", Value(kIslVersion));
  predeclare(context, "input_file_name", make_string(context, context.main_unit.file.filename().string(), {}));
  predeclare(context, "image_width", Value(static_cast<double>(options.image_width)));
  predeclare(context, "image_height", Value(static_cast<double>(options.image_height)));
  // A run renders one frame: the scene sees it as an animation of that frame alone. Without a frame these are 0, as in
  // POV-Ray, where a clock alone makes no animation.
  for (const std::string_view name : {"frame_number", "initial_frame", "final_frame"}) {
    predeclare(context, name, Value(static_cast<double>(options.frame)));
  }
  for (const std::string_view name : {"initial_clock", "final_clock"}) {
    predeclare(context, name, Value(options.frame > 0 ? options.clock : 0.0));
  }
  predeclare(context, "clock_delta", Value(0.0));
  for (const auto& [name, value] : options.defines) {
    if (const double* number = std::get_if<double>(&value)) {
      predeclare(context, name, Value(*number));
    } else {
      predeclare(context, name, make_string(context, std::get<std::string>(value), {}));
    }
  }
}

void run(Context& context, const grammar::Unit& unit) {
  try {
    bind_predeclared(context);
    read_scene(context, unit);
    context.tell_rest();
  } catch (const Stopped&) {
    // The function that threw it has reported it.
  } catch (const std::bad_alloc&) {
    context.report_out_of_memory();
  }
  try {
    close_all_files(context);
    if (!context.has_errors()) stage_written_files(context);
  } catch (const Stopped&) {
    // One error too many; it was reported.
  }
  scene::Settings& settings = context.database.settings;
  // Decided by the whole text: a `#version` after the objects counts too, and so does one in an include file.
  settings.language_version = context.version.of_defaults();
  const bool has_gamma = settings.assumed_gamma || settings.assumed_gamma_srgb;
  if (!has_gamma && settings.language_version >= 3.7) settings.assumed_gamma = 1;
  settings.noise_generator = context.noise_generator();
}

void evaluate_within(grammar::Loader& loader, grammar::SymbolTable& symbols, const grammar::Unit& unit,
                     const EvaluateOptions& options, const RunLimits& limits, MemoryAccount& memory,
                     EvaluatedScene& scene, DiagnosticSink& sink) {
  Context context(loader, symbols, unit, options, limits, memory, sink);
  const bool ran = run_on_stack(stack_bytes(options.limits), [&] { run(context, unit); });
  if (!ran) {
    sink.error({}, fmt::format("the system has no stack for a depth of {}", options.limits.max_depth),
               "a smaller `--max-depth` needs less");
    return;
  }
  prune(context.database);
  scene.database = std::move(context.database);
  scene.origins = std::move(context.origins);
}

}  // namespace

std::uint64_t steps_at_point(const Limits& limits) {
  constexpr double kMost = 1e18;  // no run takes as many
  return static_cast<std::uint64_t>(std::min(limits.max_turns, kMost));
}

EvaluatedScene evaluate(grammar::Loader& loader, grammar::SymbolTable& symbols, const grammar::Unit& unit,
                        const EvaluateOptions& options, DiagnosticSink& sink) {
  EvaluatedScene scene;
  Budget own(options.limits.max_memory_bytes);
  RunLimits limits = options.run;
  if (limits.budget == nullptr) limits.budget = &own;
  limits.steps_at_point = steps_at_point(options.limits);
  MemoryAccount memory(limits.budget);
  evaluate_within(loader, symbols, unit, options, limits, memory, scene, sink);
  // The values are gone; the scene's own memory is left.
  if (options.run.budget != nullptr) scene.charge = std::move(memory);
  return scene;
}

}  // namespace isl::interpreter
