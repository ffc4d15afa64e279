// `isl check`: everything short of rendering; a scene that it accepts can be rendered. It must start and end in a
// moment, so it loads no image library and compiles no scene.
#include "cli/commands/commands.h"
#include "cli/output/console.h"
#include "cli/session/drawable.h"
#include "cli/session/report.h"
#include "cli/session/used_files.h"
#include "cli/summary/scene_extent.h"
#include "cli/summary/scene_summary.h"
#include "cli/summary/view_check.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <string>

namespace isl::cli {
namespace {

std::string counted(std::uint64_t count, std::string_view singular) {
  return fmt::format("{} {}{}", count, singular, count == 1 ? "" : "s");
}

std::string vector_text(const Imath::V3d& v) { return fmt::format("<{:.6g}, {:.6g}, {:.6g}>", v.x, v.y, v.z); }

std::string summary_text(const Session& session, const SceneSummary& summary, const SceneExtent& extent) {
  std::string text =
      fmt::format("{}: {}", visible_name(session.display_name()), counted(summary.primitives(), "primitive"));
  if (summary.fields > 0)
    text += fmt::format(", {} in {}", counted(summary.fields, "field"), counted(summary.blobs, "blob"));
  if (summary.solids > 0) text += fmt::format(", {}", counted(summary.solids, "solid"));
  text += fmt::format(", {}, {}\n", counted(summary.lights, "light"), counted(summary.textures, "texture"));
  if (!extent.box.isEmpty()) {
    text += fmt::format("bounding box: {} to {}{}\n", vector_text(extent.box.min), vector_text(extent.box.max),
                        extent.unbounded ? ", without infinite objects" : "");
    text += fmt::format("a camera that sees it: {}\n", suggest_camera(extent.box));
  } else if (extent.unbounded) {
    text += "bounding box: none, because all objects are infinite\n";
  }
  return text + "files:\n" + files_table(session.used_files());
}

nlohmann::ordered_json array_of(const Imath::V3d& v) { return {v.x, v.y, v.z}; }

void print_json(Session& session, const SceneSummary& summary, const SceneExtent& extent) {
  nlohmann::ordered_json document;
  document["diagnostics"] = problems_as_json(session);
  document["scene"] = {
      {"primitives", summary.primitives()}, {"fields", summary.fields}, {"blobs", summary.blobs},
      {"solids", summary.solids},           {"lights", summary.lights}, {"textures", summary.textures}};
  if (extent.box.isEmpty()) {
    document["bounding_box"] = nullptr;
    document["camera"] = nullptr;
  } else {
    document["bounding_box"] = {{"min", array_of(extent.box.min)}, {"max", array_of(extent.box.max)}};
    document["camera"] = suggest_camera(extent.box);
  }
  document["unbounded"] = extent.unbounded;
  document["files"] = files_json(session.used_files());
  document["time"] = {{"parse", session.parse_seconds()}, {"evaluate", session.evaluate_seconds()}};
  print_document(document);
}

}  // namespace

ExitCode run(const CheckCommand& command) {
  Session session(command.scene);
  if (const ExitCode code = session.evaluate(); code != ExitCode::done) return report_failure(session, code);
  const DrawableScene drawable(session, PictureOptions().quality);
  if (drawable.is_refused()) return report_failure(session, ExitCode::scene_error);
  const scene::Database& database = session.scene().database;
  const SceneSummary summary = summarise(database);
  const SceneExtent extent = extent_of(database);
  warn_of_view(session, summary, extent);
  if (const ExitCode code = finish(OutputWriter(session.outputs())); code != ExitCode::done) return code;
  if (command.scene.format == OutputFormat::json) {
    print_json(session, summary, extent);
  } else {
    print_problems(session);
    print(Stream::output, summary_text(session, summary, extent));
  }
  return ExitCode::done;
}

}  // namespace isl::cli
