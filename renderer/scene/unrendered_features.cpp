#include "renderer/scene/unrendered_features.h"

namespace isl::scene {
namespace {

/// A camera that bends rays or sends them side by side shows what a perspective one of its vectors shows, more or less.
template <CameraKind kind>
constexpr Feature<Camera> camera_kind(std::string_view what) {
  return {what, [](const Camera& camera) { return camera.kind == kind; },
          [](Camera& camera) { camera.kind = CameraKind::perspective; }};
}

constexpr Feature<Camera> kCameraFeatures[] = {
    camera_kind<CameraKind::orthographic>("an `orthographic` camera"),
    camera_kind<CameraKind::fisheye>("a `fisheye` camera"),
    camera_kind<CameraKind::ultra_wide_angle>("an `ultra_wide_angle` camera"),
    camera_kind<CameraKind::omnimax>("an `omnimax` camera"),
    camera_kind<CameraKind::panoramic>("a `panoramic` camera"),
    camera_kind<CameraKind::cylinder>("a `cylinder` camera"),
    camera_kind<CameraKind::spherical>("a `spherical` camera"),
    {"focal blur", [](const Camera& camera) { return camera.blur.has_value(); },
     [](Camera& camera) { camera.blur.reset(); }},
    {"`normal` of a camera", [](const Camera& camera) { return camera.normal != kNoNormal; },
     [](Camera& camera) { camera.normal = kNoNormal; }},
};

constexpr Feature<Light> kLightFeatures[] = {
    {"`spotlight`", [](const Light& light) { return light.kind == LightKind::spotlight; },
     [](Light& light) { light.kind = LightKind::point; }},
    {"a `cylinder` of light", [](const Light& light) { return light.kind == LightKind::cylinder; },
     [](Light& light) { light.kind = LightKind::point; }},
    {"`parallel`", [](const Light& light) { return light.parallel; }, [](Light& light) { light.parallel = false; }},
    {"`area_light`", [](const Light& light) { return light.area.has_value(); },
     [](Light& light) { light.area.reset(); }},
    {"`fade_distance`", [](const Light& light) { return light.fade_distance > 0 && light.fade_power > 0; },
     [](Light& light) { light.fade_distance = light.fade_power = 0; }},
    {"`projected_through`", [](const Light& light) { return light.projected_through != kNoGroup; },
     [](Light& light) { light.projected_through = kNoGroup; }},
};

// `hollow` and `no_reflection` are not here: they change nothing without fog and reflection, which are listed on their
// own.
constexpr Feature<Object> kObjectFeatures[] = {
    {"`no_image`", [](const Object& object) { return object.no_image; },
     [](Object& object) { object.no_image = false; }},
    {"`double_illuminate`", [](const Object& object) { return object.double_illuminate; },
     [](Object& object) { object.double_illuminate = false; }},
    {"`interior_texture`", [](const Object& object) { return object.interior_texture != kNoTexture; },
     [](Object& object) { object.interior_texture = kNoTexture; }},
};

constexpr Feature<Group> kGroupFeatures[] = {
    {"`light_group`", [](const Group& group) { return group.is_light_group; },
     [](Group& group) { group.is_light_group = false; }},
};

constexpr WorldFeature kWorldFeatures[] = {
    {"`sky_sphere`", [](const Database& database) { return std::size_t{database.sky_sphere.has_value()}; },
     [](const Database& database) { return database.sky_sphere->origin; },
     [](Database& database) { database.sky_sphere.reset(); }},
    {"`fog`", [](const Database& database) { return database.fogs.size(); },
     [](const Database& database) { return database.fogs[0].origin; },
     [](Database& database) { database.fogs.clear(); }},
    {"`rainbow`", [](const Database& database) { return database.rainbows.size(); },
     [](const Database& database) { return database.rainbows[0].origin; },
     [](Database& database) { database.rainbows.clear(); }},
};

}  // namespace

std::span<const Feature<Camera>> camera_features() { return kCameraFeatures; }
std::span<const Feature<Light>> light_features() { return kLightFeatures; }
std::span<const Feature<Object>> object_features() { return kObjectFeatures; }
std::span<const Feature<Group>> group_features() { return kGroupFeatures; }
std::span<const WorldFeature> world_features() { return kWorldFeatures; }

}  // namespace isl::scene
