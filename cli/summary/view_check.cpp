#include "cli/summary/view_check.h"

#include "renderer/queries/insides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace isl::cli {

void warn_of_view(Session& session, const SceneSummary& summary, const SceneExtent& extent) {
  const scene::Database& database = session.scene().database;
  const bool has_bounds = !extent.box.isEmpty() && !extent.unbounded;
  if (has_bounds && !may_see(database.camera.value_or(scene::Camera{}), extent.box)) {
    const char* const message = database.camera ? "the camera sees nothing of the scene"
                                                : "there is no camera, and the default one sees nothing of the scene";
    session.sink().warning({}, message, fmt::format("this one sees it: {}", suggest_camera(extent.box)));
  }
  // The blocks of `global_settings` that are kept as statements are those of light from all around.
  const bool has_light_around =
      std::ranges::any_of(database.statements, [](const scene::Statement& block) { return block.kind->is_setting; });
  if (summary.primitives() > 0 && summary.lights == 0 && !has_light_around) {
    session.sink().warning({}, "the scene has no light_source: only ambient light is visible");
  }
}

std::string black_line(const scene::Database& database, const render::Image& image) {
  const auto is_lit = [](double value) { return value > 0; };
  for (std::size_t pixel = 0; pixel < image.rgba.size(); pixel += 4) {
    if (image.has_alpha || std::any_of(&image.rgba[pixel], &image.rgba[pixel] + 3, is_lit)) return {};
  }
  const scene::Vec3 eye = database.camera.value_or(scene::Camera{}).location;
  const render::Insides insides(database);
  constexpr std::uint64_t kMostSteps = 1'000'000;  // a tenth of a second or two
  StepCounter steps(kMostSteps);
  const bool is_inside = std::ranges::any_of(database.objects, [&](const scene::Object& object) {
    // A camera before a flat wall is as often on its inner side as on the other.
    const auto is_flat = [&](scene::SolidKind kind) {
      return kind == scene::SolidKind::plane || kind == scene::SolidKind::disc;
    };
    const bool is_wall = object.kind == scene::Object::Kind::solid && is_flat(database.solids[object.shape].kind);
    return !is_wall && insides.is_inside(object, eye, steps);
  });
  return is_inside && !steps.is_spent() ? "the picture is black: the camera is inside an object" : "";
}

}  // namespace isl::cli
