// `isl render`: from the command line to image files. All checks that need no tracing run before it.
#include "cli/commands/commands.h"

#include "base/content_hash.h"
#include "cli/options/render_settings.h"
#include "cli/output/closing_line.h"
#include "cli/output/console.h"
#include "cli/output/output_files.h"
#include "cli/output/progress.h"
#include "cli/output/run_end.h"
#include "cli/output/stopwatch.h"
#include "cli/output/version.h"
#include "cli/session/drawable.h"
#include "cli/session/report.h"
#include "cli/session/used_files.h"
#include "cli/summary/statistics.h"
#include "cli/summary/view_check.h"
#include "renderer/accuracy/measured_layers.h"
#include "renderer/film/film.h"
#include "renderer/image/layer_picture.h"
#include "renderer/render.h"
#include "renderer/trace/tracer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace isl::cli {
namespace {

namespace fs = std::filesystem;

ExitCode tell(const OutputProblem& problem) {
  print_error(problem.message);
  return problem.code;
}

/// Every file that the command may write, those of an interrupted picture too.
std::vector<OutputPlace> places_of(const RenderCommand& command, const std::vector<fs::path>& pictures) {
  std::vector<OutputPlace> places;
  const bool is_asked = !command.picture.outputs.empty();
  for (const fs::path& file : pictures) {
    places.push_back({file, fmt::format("{} {}", is_asked ? "-o" : "the picture", file.string())});
  }
  if (!command.picture.statistics.empty()) {
    places.push_back({command.picture.statistics, "--stats " + command.picture.statistics.string()});
  }
  const std::vector<fs::path> partial = partial_names(pictures);
  for (const fs::path& file : partial) places.push_back({file, "the unfinished picture " + file.string()});
  for (const std::vector<fs::path>& files : {pictures, partial}) {
    for (const LayerFile& layer : layer_files(files, command.picture.layers)) {
      places.push_back({layer.file, "the layer " + layer.file.string()});
    }
  }
  return places;
}

/// Called before the scene is read: a misspelt name should not cost an hour of rendering.
OutputProblem claim_places(const RenderCommand& command, const std::vector<fs::path>& pictures, OutputSet& outputs) {
  OutputProblem problem = check_pictures(pictures);
  return problem.none() ? claim(outputs, places_of(command, pictures)) : problem;
}

/// One hash over all texts of the scene: its own first, then the others in the order in which they were read.
std::uint64_t scene_hash(const grammar::SourceMap& sources, std::uint32_t begin) {
  ContentHash hash;
  while (sources.position(begin).line != 0) {
    const std::string_view text = sources.text({begin, std::numeric_limits<std::uint32_t>::max()});
    hash.add(text);
    begin += static_cast<std::uint32_t>(text.size()) + 1;  // each file owns one offset past its last byte
  }
  return hash.value();
}

render::ImageFileOptions file_options(const RenderCommand& command, const RenderSettings& settings,
                                      const Session& session) {
  render::ImageFileOptions options;
  options.bits = command.picture.bits;
  options.metadata = {
      {"Software", fmt::format("isl {}", kVersion)},
      {"isl:Scene", session.name()},
      {"isl:SceneHash", fmt::format("{:016x}", scene_hash(session.sources(), session.unit().span.begin))},
      {"isl:Files", files_text(session.used_files())},
      {"isl:Options", canonical_options(command, settings)}};
  return options;
}

struct Picture {
  render::RenderResult result;
  double compile_seconds = 0;
  std::size_t grid_bytes = 0;
  double share = 1;  ///< of the work that was done
  std::optional<scene::Refusal> refusal;
};

/// Takes the memory that the picture needs until it is in its file, before anything is read.
std::optional<OutputProblem> take_picture_memory(const RenderCommand& command, Charge& charge) {
  const auto& [width, height] = command.scene.size;
  render::PixelRect rect{0, 0, width, height};
  if (command.picture.crop) {
    // Besides the window, the film has a pixel on every side of it.
    const auto& [x0, y0, x1, y1] = *command.picture.crop;
    rect = {std::max(x0 - 1, 0), std::max(y0 - 1, 0), std::min(x1 + 1, width), std::min(y1 + 1, height)};
  }
  const std::size_t pixels = rect.area();
  const std::size_t bytes =
      render::picture_bytes(pixels, command.picture.layers) + render::measuring_bytes(pixels, command.picture.layers);
  if (charge.grow(bytes)) return std::nullopt;
  return OutputProblem{
      ExitCode::command_line_error,
      fmt::format("--size {}x{}: a picture of this size, with its layers, takes {:.3g} GB of memory, more than the "
                  "limit of {:.3g} GB; `--max-memory` raises the limit",
                  width, height, static_cast<double>(bytes) * 1e-9,
                  static_cast<double>(command.scene.limits.max_memory_bytes) * 1e-9)};
}

Picture make_picture(const RenderCommand& command, RenderSettings settings, const scene::Database& database,
                     Session& session) {
  Picture picture;
  settings.tracer.run = settings.render.run = session.limits();
  settings.render.images = &session.images();
  const Stopwatch compiling;
  const render::Tracer tracer(database, settings.tracer);
  picture.compile_seconds = compiling.seconds();
  picture.refusal = tracer.refusal();
  if (picture.refusal) return picture;
  picture.grid_bytes = tracer.grid_bytes();

  const bool shows_bar = isatty(STDERR_FILENO) != 0 && !command.picture.quiet;
  ProgressBar bar(shows_bar ? stderr : nullptr);
  // Rendering shades and samples pixels several times; measuring only finds first hits, one or two a pixel.
  const bool measures = render::any_measured(settings.render.aovs);
  const double render_share = measures ? 0.7 : 1;
  settings.render.progress = [&](double done) { bar.update(render_share * done); };
  picture.result = render::render(database, tracer, settings.render);
  picture.refusal = picture.result.refusal;
  picture.share = render_share * picture.result.share;
  if (measures && !picture.refusal) {
    picture.refusal = render::measure_layers(
        database, settings.tracer, tracer, settings.render.aovs, settings.render.threads,
        [&](double done) { bar.update(render_share + (1 - render_share) * done); }, picture.result.image);
    if (is_set(session.limits().stop)) picture.result.complete = false;
  }
  return picture;
}

std::vector<std::string> names_of(const std::vector<fs::path>& files) {
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(display_name(file));
  return names;
}

/// Prints the closing line: the files written, and the time.
void tell_result(const RenderCommand& command, Session& session, const std::vector<fs::path>& files,
                 const render::Image& image, bool complete, const nlohmann::ordered_json& statistics, double seconds) {
  if (command.scene.format == OutputFormat::json) {
    print_document({{"diagnostics", problems_as_json(session)},
                    {"outputs", names_of(files)},
                    {"complete", complete},
                    {"statistics", statistics}});
  } else if (!complete) {
    const std::string names = fmt::format("{}", fmt::join(names_of(files), ", "));
    print(Stream::error,
          fmt::format("isl: {}; {}\n", text_of(stop_flag().reason()),
                      files.empty() ? "no file was written" : "the finished part is in " + visible_name(names)));
  } else if (!command.picture.quiet) {
    print(Stream::error, closing_line(names_of(files), image, seconds) + "\n");
  }
}

/// Prints how many pixels are not certain. True if there are any.
bool tell_uncertain(const RenderCommand& command, const render::RenderStatistics& statistics) {
  const std::string line = uncertain_line(statistics);
  if (line.empty()) return false;
  if (command.picture.strict) {
    print_error(line);
  } else if (command.scene.format == OutputFormat::text) {
    print(Stream::error, fmt::format("isl: warning: {}\n", line));
  }
  return true;
}

/// Says which samples the picture lacks because they are no numbers.
void warn_of_lost(Session& session, const render::LostSamples& lost) {
  const std::string message = lost_line(lost);
  if (message.empty()) return;
  const interpreter::Origin origin = session.scene().origins.resolve(lost.origin);
  report_late(session, {Severity::warning,
                        origin.span,
                        message,
                        "look for divisions by zero, and for roots, logarithms and powers outside of their domain, in "
                        "what it shows and in the lights, the air and the sky",
                        {},
                        origin.chain});
}

/// Prints how many pixels have more noise than was asked for.
void tell_noisy(const RenderCommand& command, const render::RenderStatistics& statistics) {
  const std::string line = noisy_line(statistics);
  if (!line.empty() && command.scene.format == OutputFormat::text) print(Stream::error, fmt::format("isl: {}\n", line));
}

/// Says so if nothing is seen.
void tell_black(const RenderCommand& command, const scene::Database& database, const render::Image& image) {
  const std::string line = black_line(database, image);
  if (!line.empty() && command.scene.format == OutputFormat::text)
    print(Stream::error, fmt::format("isl: warning: {}\n", line));
}

}  // namespace

ExitCode run(const RenderCommand& command) {
  const Stopwatch whole;
  Session session(command.scene);
  if (!command.picture.simd.empty() && !render::Tracer::has_simd_target(command.picture.simd)) {
    print_error(fmt::format("--simd: `{}` is not available on this machine, or not built into the program",
                            command.picture.simd));
    return ExitCode::command_line_error;
  }
  if (command.picture.solver) {
    if (const std::string problem = render::Tracer::problem_of(command.picture.solver->name); !problem.empty()) {
      print_error(fmt::format("--solver: {}", problem));
      return ExitCode::file_error;
    }
  }
  std::vector<fs::path> files = output_files(command.picture.outputs, session.name());
  if (const OutputProblem problem = claim_places(command, files, session.outputs()); !problem.none()) {
    return tell(problem);
  }
  Charge picture_memory(session.limits().budget);
  if (const auto problem = take_picture_memory(command, picture_memory)) return tell(*problem);
  if (const ExitCode code = session.evaluate(); code != ExitCode::done) return report_failure(session, code);
  const DrawableScene drawable(session, command.picture.quality);
  if (drawable.is_refused()) return report_failure(session, ExitCode::scene_error);
  const SceneSummary summary = summarise(session.scene().database);
  warn_of_view(session, summary, extent_of(session.scene().database));
  if (command.scene.format == OutputFormat::text) print_problems(session);

  const scene::Database& database = drawable.database();
  const RenderSettings settings = render_settings(command, database);
  const Picture picture = make_picture(command, settings, database, session);
  if (picture.refusal) return refuse(session, *picture.refusal);
  const bool complete = picture.result.complete;
  if (!complete) files = partial_names(files);
  const render::Image& image = picture.result.image;
  const Stopwatch writing;
  render::ImageFileOptions options = file_options(command, settings, session);
  options.threads = picture.result.statistics.threads;
  if (!complete) {
    options.metadata.push_back({"isl:Partial", fmt::format("{}; {:.0f} % of the picture was rendered",
                                                           text_of(stop_flag().reason()), 100 * picture.share)});
  }
  OutputWriter writer(session.outputs());
  for (const fs::path& file : files) writer.add(file, image, options);
  for (const LayerFile& layer : layer_files(files, command.picture.layers)) {
    writer.add(layer.file, render::layer_picture(image, *image.layer(layer.layer->name)), options);
    files.push_back(layer.file);
  }

  const PhaseTimes times{.parse = session.parse_seconds(),
                         .evaluate = session.evaluate_seconds(),
                         .compile = picture.compile_seconds,
                         .trace = picture.result.statistics.seconds,
                         .write = writing.seconds()};
  const MemoryUse memory{.database_bytes = database_bytes(database), .grid_bytes = picture.grid_bytes};
  const nlohmann::ordered_json statistics =
      statistics_json(summarise(database), times, settings, memory, picture.result.statistics);
  if (complete && !command.picture.statistics.empty()) {
    writer.add_text(command.picture.statistics, statistics.dump(2) + "\n");
  }
  if (const ExitCode code = finish(std::move(writer)); code != ExitCode::done) return code;
  warn_of_lost(session, picture.result.statistics.lost);
  tell_result(command, session, files, image, complete, statistics, whole.seconds());
  if (complete) {
    tell_noisy(command, picture.result.statistics);
    tell_black(command, database, image);
  }
  const bool is_uncertain = tell_uncertain(command, picture.result.statistics);
  if (!complete) return exit_code_of(stop_flag().reason());
  return is_uncertain && command.picture.strict ? ExitCode::scene_error : ExitCode::done;
}

}  // namespace isl::cli
