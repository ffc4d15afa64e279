// `isl accuracy`: traces the scene's camera rays with one setting after the other, and reports cost and errors of each.
#include "cli/accuracy/page.h"
#include "cli/accuracy/pictures.h"
#include "cli/accuracy/report.h"
#include "cli/commands/commands.h"
#include "cli/options/render_settings.h"
#include "cli/output/console.h"
#include "cli/output/output_files.h"
#include "cli/output/progress.h"
#include "cli/output/run_end.h"
#include "cli/session/drawable.h"
#include "cli/session/report.h"
#include "renderer/accuracy/comparison.h"
#include "renderer/render.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace isl::cli {
namespace {

namespace fs = std::filesystem;

struct ReportFiles {
  fs::path page, json, csv;
};

ReportFiles report_files(const AccuracyCommand& command, const Session& session) {
  const std::string name = command.output.empty() ? session.name() + ".accuracy" : command.output.string();
  return {name + ".html", name + ".json", name + ".csv"};
}

/// The command line that makes the same report in the same folder.
std::string command_text(const AccuracyCommand& command) {
  std::string text = fmt::format("isl accuracy {} -s {}x{} --repeats {}", command.scene.scene.string(),
                                 command.scene.size.width, command.scene.size.height, command.repeats);
  for (const SolverSetting& setting : command.settings) text += fmt::format(" --setting \"{}\"", setting.name());
  if (command.shadows) text += " --shadows";
  if (command.unblended) text += " --skeleton";
  if (command.scene.lenient) text += " --lenient";
  if (command.scene.clock != 0) text += fmt::format(" --clock {}", command.scene.clock);
  if (command.scene.frame != 0) text += fmt::format(" --frame {}", command.scene.frame);
  for (const fs::path& folder : command.scene.include_paths) text += fmt::format(" -I {}", folder.string());
  for (const fs::path& folder : command.scene.read_folders) text += fmt::format(" --allow-read {}", folder.string());
  for (const auto& [name, value] : command.scene.defines) {
    const double* const number = std::get_if<double>(&value);
    text += number != nullptr ? fmt::format(" -D {}={}", name, *number)
                              : fmt::format(" -D {}={}", name, std::get<std::string>(value));
  }
  return text;
}

render::Comparison measure(const AccuracyCommand& command, const std::vector<Rung>& rungs,
                           const scene::Database& database, const RunLimits& limits) {
  std::vector<render::TracerOptions> settings;
  for (const Rung& rung : rungs) settings.push_back(rung.tracer);
  for (render::TracerOptions& setting : settings) setting.run = limits;
  render::TracerOptions reference = exact_rung(command, database).tracer;
  reference.run = limits;
  const auto base = std::ranges::find_if(rungs, [](const Rung& rung) { return rung.setting.is_default(); });
  ProgressBar bar(isatty(STDERR_FILENO) != 0 ? stderr : nullptr);
  render::ComparisonOptions options;
  options.width = command.scene.size.width;
  options.height = command.scene.size.height;
  options.threads = command.threads;
  options.rounds = command.repeats;
  options.shadows = command.shadows;
  options.progress = [&bar](double done) { bar.update(done); };
  options.run = limits;
  return render::compare(database, reference, settings, static_cast<std::size_t>(base - rungs.begin()), options);
}

/// The picture as `isl render` makes it by default.
render::RenderResult picture_of(const AccuracyCommand& command, const scene::Database& database,
                                const RunLimits& limits) {
  RenderCommand render;
  render.scene = command.scene;
  render.picture.threads = command.threads;
  render.picture.unblended = command.unblended;
  RenderSettings settings = render_settings(render, database);
  settings.tracer.run = settings.render.run = limits;
  const render::Tracer tracer(database, settings.tracer);
  render::RenderResult result = render::render(database, tracer, settings.render);
  if (tracer.refusal()) result.refusal = tracer.refusal();
  return result;
}

}  // namespace

ExitCode run(const AccuracyCommand& command) {
  Session session(command.scene);
  const ReportFiles files = report_files(command, session);
  std::vector<OutputPlace> places;
  for (const fs::path& file : {files.page, files.json, files.csv}) {
    places.push_back({file, "the report " + file.string()});
  }
  if (const OutputProblem problem = claim(session.outputs(), places); !problem.none()) {
    print_error(problem.message);
    return problem.code;
  }
  if (const ExitCode code = session.evaluate(); code != ExitCode::done) return report_failure(session, code);
  const DrawableScene drawable(session, PictureOptions().quality);
  if (drawable.is_refused()) return report_failure(session, ExitCode::scene_error);
  if (command.scene.format == OutputFormat::text) print_problems(session);

  AccuracyReport report;
  report.scene = session.display_name();
  report.command = command_text(command);
  report.size = command.scene.size;
  report.rungs = ladder(command, drawable.database());
  for (const Rung& rung : report.rungs) {
    if (const std::string problem = render::Tracer::problem_of(rung.tracer.solver); !problem.empty()) {
      print_error(fmt::format("--setting {}: {}", rung.setting.name(), problem));
      return ExitCode::file_error;
    }
  }
  report.comparison = measure(command, report.rungs, drawable.database(), session.limits());
  if (report.comparison.refusal) return refuse(session, *report.comparison.refusal);
  if (!report.comparison.complete) return report_failure(session, exit_code_of(stop_flag().reason()));
  const render::RenderResult picture = picture_of(command, drawable.database(), session.limits());
  if (picture.refusal) return refuse(session, *picture.refusal);
  if (!picture.complete) return report_failure(session, exit_code_of(stop_flag().reason()));

  nlohmann::ordered_json document = table_json(report);
  const std::string json_text = document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  const AccuracyPictures pictures = accuracy_pictures(report, picture.image);
  if (!pictures.problem.empty()) {
    print_error(fmt::format("cannot write {}: {}", files.page.string(), pictures.problem));
    return ExitCode::file_error;
  }
  OutputWriter writer(session.outputs());
  writer.add_text(files.page, accuracy_page(report, pictures));
  writer.add_text(files.json, json_text);
  writer.add_text(files.csv, table_csv(report));
  if (const ExitCode code = finish(std::move(writer)); code != ExitCode::done) return code;
  if (command.scene.format == OutputFormat::json) {
    document["diagnostics"] = problems_as_json(session);
    document["outputs"] = {files.page.string(), files.json.string(), files.csv.string()};
    print_document(document);
  } else {
    print(Stream::output, table_text(report));
  }
  return ExitCode::done;
}

}  // namespace isl::cli
