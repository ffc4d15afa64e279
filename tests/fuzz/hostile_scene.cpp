#include "tests/fuzz/hostile_scene.h"

#include "cli/options/option_values.h"
#include "cli/options/solver_choice.h"
#include "cli/session/diagnostic_printer.h"
#include "cli/summary/scene_extent.h"
#include "cli/summary/scene_summary.h"
#include "grammar/loader.h"
#include "interpreter/evaluate.h"
#include "renderer/effects/plan.h"
#include "renderer/film/camera.h"
#include "renderer/queries/faint.h"
#include "renderer/queries/object_queries.h"
#include "renderer/render.h"
#include "renderer/trace/tracer.h"
#include "tests/fuzz/hostile_text.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace isl::test {
namespace {

constexpr int kWidth = 4, kHeight = 3;

/// Limit of the primitives, where each copy counts: a group of groups of groups soon has millions.
constexpr std::uint64_t kMostDrawn = 100000;

/// Sets a flag when time is up, unless it is destroyed before.
class Watchdog {
 public:
  explicit Watchdog(StopFlag& flag) : thread_([this, &flag] { watch(flag); }) {}
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
  ~Watchdog() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }

 private:
  void watch(StopFlag& flag) {
    std::unique_lock lock(mutex_);
    const auto limit = std::chrono::duration<double>(kSecondsAllowed);
    if (!changed_.wait_for(lock, limit, [this] { return is_over_; })) flag.set(StopReason::time_over);
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_over_ = false;
  std::thread thread_;
};

interpreter::EvaluateOptions options_of(scene::Queries& queries, const StopFlag& stop, bool lenient) {
  interpreter::EvaluateOptions options;
  options.limits = {.max_depth = 100,
                    .max_turns = 20000,
                    .max_primitives = 2000,
                    .max_memory_bytes = std::size_t{256} << 20,
                    .max_include_depth = 8};
  options.lenient = lenient;
  options.image_width = kWidth;
  options.image_height = kHeight;
  options.queries = &queries;
  options.run.stop = &stop;
  return options;
}

/// Prints everything, because printing a message reads the text that it is about.
std::string trouble_in(const DiagnosticSink& sink, const grammar::SourceMap& sources) {
  std::string trouble;
  for (const Diagnostic& diagnostic : sink.diagnostics()) {
    const std::string printed = cli::format_diagnostic(diagnostic, sources, false).text();
    const bool has_place = sources.position(diagnostic.span.begin).line != 0;
    if (printed.empty() || diagnostic.message.empty()) trouble += "an empty message\n";
    if (diagnostic.severity == Severity::error && !has_place) trouble += "an error without a place: " + printed;
  }
  return trouble;
}

/// The command must parse the scene's own solver and tolerance before they are used.
bool has_readable_settings(const scene::Settings& settings) {
  const bool is_solver = settings.solver.empty() || cli::parse_solver(settings.solver).ok();
  return is_solver && (settings.tolerance.empty() || cli::parse_tolerance(settings.tolerance).ok());
}

/// Computes what `check` reports for a scene without errors.
void summarise(const scene::Database& database) {
  static_cast<void>(render::faint_components(database));
  static_cast<void>(cli::summarise(database).primitives());
  const cli::SceneExtent extent = cli::extent_of(database);
  if (extent.box.isEmpty()) return;
  static_cast<void>(cli::suggest_camera(extent.box));
  if (database.camera) static_cast<void>(cli::may_see(*database.camera, extent.box));
}

void draw(scene::Database& database, const StopFlag& stop) {
  render::leave_out(render::plan_of(database), database);
  render::TracerOptions tracing;
  tracing.pixel_angle = render::pixel_angle(database.camera.value_or(scene::Camera{}), kWidth, kHeight);
  const render::Tracer tracer(database, tracing);
  render::RenderOptions drawing;
  drawing.width = kWidth;
  drawing.height = kHeight;
  drawing.threads = 1;
  drawing.samples = 1;
  drawing.run.stop = &stop;
  static_cast<void>(render::render(database, tracer, drawing));
}

}  // namespace

SceneVerdict try_scene(std::string_view text, const std::filesystem::path& folder,
                       const std::vector<std::filesystem::path>& search_path, bool lenient) {
  remember_for_crash(text);
  StopFlag stop;
  SceneVerdict verdict;
  {
    const Watchdog watchdog(stop);
    Budget budget(std::size_t{512} << 20);  // of texts and trees; the evaluation has one of its own
    grammar::SourceMap sources;
    grammar::SymbolTable symbols;
    grammar::Arena arena;
    DiagnosticSink sink;
    grammar::Loader loader(sources, symbols, arena, sink,
                           {.folders = {.search_path = search_path}, .run = {&budget, &stop}});
    const grammar::Unit* const unit = loader.load_text((folder / "scene.pov").string(), std::string(text));
    if (!unit) return {.trouble = "the text was not read at all"};
    if (!sink.has_errors()) {
      render::ObjectQueries queries;
      interpreter::EvaluatedScene scene =
          interpreter::evaluate(loader, symbols, *unit, options_of(queries, stop, lenient), sink);
      verdict.is_accepted = !sink.has_errors() && has_readable_settings(scene.database.settings);
      if (verdict.is_accepted) {
        summarise(scene.database);
        verdict.is_rendered = lenient || render::plan_of(scene.database).refused.empty();
        if (cli::summarise(scene.database).primitives() > kMostDrawn) verdict.is_rendered = false;
        if (verdict.is_rendered) draw(scene.database, stop);
      }
    }
    verdict.trouble = trouble_in(sink, sources);
  }
  verdict.is_slow = stop.is_set();
  return verdict;
}

}  // namespace isl::test
