#include "cli/options/render_settings.h"

#include "renderer/film/camera.h"
#include "renderer/scene/default_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace isl::cli {
namespace {

std::string value_text(const std::variant<double, std::string>& value) {
  if (const double* const number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  return fmt::format("\"{}\"", std::get<std::string>(value));
}

}  // namespace

RenderSettings render_settings(const RenderCommand& command, const scene::Database& database) {
  const PictureOptions& picture = command.picture;
  const PictureSize& size = command.scene.size;
  RenderSettings settings;
  if (picture.solver) {
    settings.solver = *picture.solver;
  } else if (!database.settings.solver.empty()) {
    settings.solver = parse_solver(database.settings.solver).value();
  }
  if (picture.tolerance) {
    settings.tolerance = *picture.tolerance;
  } else if (!database.settings.tolerance.empty()) {
    settings.tolerance = parse_tolerance(database.settings.tolerance).value();
  }
  const bool is_exact = settings.solver.name == render::SolverName::exact;
  settings.tolerance_text = is_exact ? "rounding" : to_text(settings.tolerance);

  const scene::Camera camera = database.camera.value_or(scene::default_camera(size.width, size.height));
  settings.tracer.solver = settings.solver.name;
  settings.tracer.interpolants = settings.solver.interpolants;
  settings.tracer.paper = settings.solver.paper;
  settings.tracer.step = settings.solver.step;
  settings.tracer.relaxation = settings.solver.relaxation;
  settings.tracer.octree = settings.solver.octree;
  settings.tracer.packets = !settings.solver.single && !settings.solver.digits;
  settings.tracer.digits = settings.solver.digits;
  settings.tracer.tolerance = settings.tolerance;
  settings.tracer.pixel_angle =
      render::pixel_angle(camera, size.width, size.height, render::CameraFunctions::of(database));
  settings.tracer.unblended = picture.unblended;
  settings.tracer.simd = picture.simd;

  settings.render.width = size.width;
  settings.render.height = size.height;
  settings.render.threads = picture.threads;
  settings.render.samples = picture.samples;
  settings.render.aa = picture.aa_threshold.value_or(kEdgeThreshold);
  settings.render.max_noise = picture.max_noise;
  if (!picture.samples && !picture.aa_threshold && !picture.max_noise) {
    const render::Plan plan = render::plan_of(database, {.quality = picture.quality, .without = command.scene.without});
    if (plan.is_soft()) settings.render.max_noise = kSoftNoise;
  }
  settings.render.quality = picture.quality;
  settings.render.without = command.scene.without;
  settings.render.alpha = picture.alpha;
  if (picture.crop) {
    const auto& [x0, y0, x1, y1] = *picture.crop;
    settings.render.crop = render::PixelRect{x0, y0, x1, y1};
  }
  settings.render.aovs = picture.layers;
  return settings;
}

std::string canonical_options(const RenderCommand& command, const RenderSettings& settings) {
  const PictureOptions& picture = command.picture;
  std::string text = fmt::format("-s {}x{}", command.scene.size.width, command.scene.size.height);
  if (picture.crop) text += fmt::format(" --crop {}", fmt::join(*picture.crop, ","));
  if (picture.samples) {
    text += fmt::format(" --samples {}", *picture.samples);
  } else if (settings.render.max_noise) {
    text += fmt::format(" --max-noise {}", *settings.render.max_noise);
  } else {
    text += fmt::format(" --aa {}", settings.render.aa);
  }
  text += fmt::format(" --quality {}", picture.quality);
  if (!command.scene.without.empty()) text += fmt::format(" --without {}", fmt::join(command.scene.without, ","));
  if (picture.alpha) text += " --alpha";
  if (picture.unblended) text += " --skeleton";
  text += " --solver " + to_text(settings.solver);
  if (settings.solver.name != render::SolverName::exact) text += " --tolerance " + settings.tolerance_text;
  if (command.scene.lenient) text += " --lenient";
  if (command.scene.clock != 0) text += fmt::format(" --clock {}", command.scene.clock);
  if (command.scene.frame != 0) text += fmt::format(" --frame {}", command.scene.frame);
  std::map<std::string, std::string> defines;  // the later of two with one name counts
  for (const Define& define : command.scene.defines) defines[define.first] = value_text(define.second);
  for (const auto& [name, value] : defines) text += fmt::format(" -D {}={}", name, value);
  return text;
}

}  // namespace isl::cli
