#include "renderer/effects/not_rendered.h"

#include <algorithm>

namespace isl::render {
namespace {

using scene::Camera;
using scene::CameraItem;
using scene::Database;
using scene::Group;
using scene::Light;
using scene::LightItem;

/// An effect that one kind of record calls for.
template <class Record>
struct Row {
  std::string_view name, summary;
  std::string_view what;  ///< as the language writes it, for refusals
  OriginId (*word)(const Record&);
  bool (*is_used)(const Record&);
  void (*leave_out)(Record&);
  int from_quality = 0;
};

/// The place of an item in the text.
template <class Record, auto item>
OriginId said(const Record& record) {
  return record.said_at[item];
}

constexpr Row<Camera> kCameraRows[] = {
    {"focal_blur", "blur outside the focus", "focal blur", said<Camera, CameraItem::blur>,
     [](const Camera& camera) { return camera.blur.has_value(); }, [](Camera& camera) { camera.blur.reset(); }},
};

constexpr Row<Light> kLightRows[] = {
    {"jitter", "area lights whose points move at random", "`jitter` of an area light", said<Light, LightItem::jitter>,
     [](const Light& light) { return light.area && light.area->jitter; },
     [](Light& light) {
       if (light.area) light.area->jitter = false;
     },
     5},
};

Effect camera_effect(const Row<Camera>& row) {
  return {.name = row.name,
          .summary = row.summary,
          .find =
              [&row](const SceneUse& use, Requests& requests, std::string_view& /*reason*/) {
                const std::optional<Camera>& camera = use.database().camera;
                if (camera && row.is_used(*camera)) requests.add(row.what, row.word(*camera), camera->origin);
              },
          .leave_out =
              [&row](Database& database) {
                if (database.camera && row.is_used(*database.camera)) row.leave_out(*database.camera);
              }};
}

template <class Record>
void leave_out(const Row<Record>& row, std::vector<Record>& records) {
  for (Record& record : records) {
    if (row.is_used(record)) row.leave_out(record);
  }
}

/// `uses`: the function of SceneUse that returns the records; `leave_out_all` leaves the row out of all of them.
template <class Record, class Uses, class LeaveOut>
Effect record_effect(const Row<Record>& row, Uses uses, LeaveOut leave_out_all) {
  return {.name = row.name,
          .summary = row.summary,
          .from_quality = row.from_quality,
          .find =
              [&row, uses](const SceneUse& use, Requests& requests, std::string_view& /*reason*/) {
                for (const Use<Record>& record : (use.*uses)()) {
                  if (row.is_used(*record.record)) requests.add(row.what, row.word(*record.record), record.user);
                }
              },
          .leave_out = [&row, leave_out_all](Database& database) { leave_out_all(row, database); }};
}

}  // namespace

void add_world_not_rendered(std::vector<Effect>& effects) {
  for (const Row<Camera>& row : kCameraRows) effects.push_back(camera_effect(row));
  for (const Row<Light>& row : kLightRows) {
    effects.push_back(record_effect(row, &SceneUse::lights, [](const Row<Light>& light_row, Database& database) {
      leave_out(light_row, database.lights);
      for (Group& group : database.groups) leave_out(light_row, group.lights);
    }));
  }
}

std::vector<Effect> effects_not_rendered() {
  std::vector<Effect> effects;
  add_world_not_rendered(effects);
  add_surfaces_not_rendered(effects);
  for (Effect& effect : effects) effect.is_rendered = false;
  return effects;
}

}  // namespace isl::render
