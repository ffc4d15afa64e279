#include "tests/renderer/integrator/picture_scene.h"
#include "tests/support/textures.h"

#include <numbers>

namespace isl::render::test {
namespace {

using scene::Finish;
using scene::SolidKind;
using scene::Transform;
using scene::Vec3;

Transform scaling(const Vec3& factors) {
  Transform result;
  result.matrix.setScale(factors);
  result.inverse.setScale(Vec3(1 / factors.x, 1 / factors.y, 1 / factors.z));
  return result;
}

Transform rotation_about_z(double degrees) {
  Transform result;
  result.matrix.setEulerAngles(Vec3(0, 0, degrees * std::numbers::pi / 180));
  result.inverse = result.matrix.transposed();
  return result;
}

Transform translation(const Vec3& offset) {
  Transform result;
  result.matrix.setTranslation(offset);
  result.inverse.setTranslation(-offset);
  return result;
}

scene::Colour grey(double value) { return {value, value, value}; }

scene::TextureId add_texture(scene::Database& database, const scene::Colour& pigment, const Finish& finish) {
  database.textures.push_back(isl::test::plain_texture(database, pigment, finish));
  return scene::TextureId(static_cast<std::uint32_t>(database.textures.size() - 1));
}

}  // namespace

void add_solid(scene::Database& database, const scene::Solid& solid, const scene::Colour& pigment, const Finish& finish,
               const Transform& world_from_object) {
  scene::Object object;
  object.shape = static_cast<std::uint32_t>(database.solids.size());
  object.parent_from_object = world_from_object;
  object.texture = add_texture(database, pigment, finish);
  database.solids.push_back(solid);
  database.objects.push_back(object);
}

scene::Database povray_solids() {
  scene::Database database;
  database.settings.assumed_gamma = 1.0;
  database.settings.ambient_light = {1, 0.9, 0.8};
  database.settings.background = {0.1, 0.2, 0.4};
  database.camera = scene::Camera{{0.5, 2, -6}, {0, -0.25, 1}, {1.2, 0, 0}, {0, 0.9, 0.225}};
  scene::Light key;
  key.location = {-4, 6, -5};
  key.colour = {0.9, 0.8, 0.7};
  scene::Light fill;
  fill.location = {5, 3, -3};
  fill.colour = {0.2, 0.3, 0.4};
  fill.shadowless = true;
  database.lights = {key, fill};

  add_solid(database, {SolidKind::plane, false, {0, 1, 0}, Vec3(0), -1, 0}, {0.7, 0.7, 0.6},
            {.ambient = grey(0.15), .diffuse = 0.7});
  add_solid(database, {SolidKind::sphere, false, {-1.2, 0, 0}, Vec3(0), 1, 0}, {0.9, 0.3, 0.2},
            {.diffuse = 0.6, .phong = 0.5, .phong_size = 25});
  add_solid(database, {SolidKind::cylinder, false, {0.6, -1, -0.5}, {1.1, 0.8, -0.2}, 0.45, 0.45}, {0.2, 0.6, 0.3},
            {.diffuse = 0.7, .specular = 0.4, .roughness = 0.02});
  add_solid(database, {SolidKind::cone, false, {2.2, -1, 0.5}, {2.2, 1, 0.5}, 0.9, 0.2}, {0.3, 0.4, 0.9},
            {.ambient = {0.2, 0.1, 0.1},
             .diffuse = 0.6,
             .brilliance = 2.5,
             .phong = 0.3,
             .phong_size = 90,
             .specular = 0.2,
             .roughness = 0.1});
  add_solid(database, {SolidKind::sphere, false, {0, 0, 0}, Vec3(0), 1, 0}, {0.8, 0.8, 0.1},
            {.diffuse = 0.5, .specular = 0.8, .roughness = 0.005},
            then(then(scaling({1.5, 0.2, 0.6}), rotation_about_z(30)), translation({0, 1.6, 1})));
  add_solid(database, {SolidKind::cylinder, true, {-0.3, -0.6, -1.6}, {0.6, -0.5, -1.9}, 0.3, 0.3}, {0.6, 0.3, 0.6},
            {.diffuse = 0.8, .phong = 0.4, .phong_size = 10});
  return database;
}

scene::Database povray_blob() {
  scene::Database database;
  database.settings.assumed_gamma = 1.0;
  database.settings.background = {0.1, 0.2, 0.4};
  database.camera = scene::Camera{{0, 1.5, -5}, {0, -0.25, 1}, {1.2, 0, 0}, {0, 0.9, 0.225}};
  scene::Light light;
  light.location = {-4, 6, -5};
  light.colour = {0.9, 0.8, 0.7};
  database.lights = {light};
  add_solid(database, {SolidKind::plane, false, {0, 1, 0}, Vec3(0), -1, 0}, {0.7, 0.7, 0.6},
            {.ambient = grey(0.15), .diffuse = 0.7});

  database.kernels.emplace_back();  // POV-Ray's own kernel
  database.transforms.push_back(then(scaling({0.5, 1, 0.7}), translation({0, 0.8, -0.4})));
  const scene::TextureId red =
      add_texture(database, {0.9, 0.1, 0.1}, {.ambient = grey(0.2), .diffuse = 0.8, .phong = 0.5, .phong_size = 5});
  const scene::TextureId blue =
      add_texture(database, {0.1, 0.2, 0.9},
                  {.ambient = grey(0.05), .diffuse = 0.3, .brilliance = 2, .specular = 0.5, .roughness = 0.1});
  const scene::TextureId green = add_texture(database, {0.2, 0.8, 0.3}, {.diffuse = 0.6});
  scene::Blob blob;
  blob.threshold = 0.6;
  blob.components = {{.a = {-0.5, 0, 0}, .radius_a = 1.2, .strength = 1, .texture = red},
                     {.a = {0.5, 0.2, 0}, .radius_a = 1.2, .strength = 1.5, .texture = blue},
                     {.a = {-1.5, -0.8, 0.5},
                      .b = {1.5, 1.2, -0.5},
                      .radius_a = 0.6,
                      .radius_b = 0.6,
                      .strength = 1.2,
                      .texture = green,
                      .skeleton = scene::Skeleton::segment},
                     {.a = {0, 0, 0}, .radius_a = 1, .strength = -0.7, .transform = scene::TransformId(0)}};
  blob.origins.resize(blob.components.size());
  database.blobs.push_back(blob);
  scene::Object object;
  object.kind = scene::Object::Kind::blob;
  object.shape = 0;
  object.texture = add_texture(database, {0.9, 0.9, 0.2}, {.diffuse = 0.6});
  database.objects.push_back(object);
  return database;
}

}  // namespace isl::render::test
