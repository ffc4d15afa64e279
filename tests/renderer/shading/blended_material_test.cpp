// A blob's blended material: every texture is finished by itself with the shared normal, then averaged. The numbers are
// POV-Ray 3.7's for the pixel where the z axis meets
//   blob { threshold .6
//     sphere { -.5*x, 1.2, 1      pigment { rgb <.9, .1, .1> } finish { ambient .2 diffuse .8 phong .5 phong_size 5 } }
//     sphere { .5*x, 1.2, 1.5    pigment { rgb <.1, .2, .9> }
//              finish { ambient .05 diffuse .3 brilliance 2 specular .5 roughness .1 } }
//     sphere { 1.2*y - .2*z, 1, -.7  pigment { rgb <.1, .9, .2> } finish { ambient .1 diffuse .6 } } }
// seen from −5 z, light_source { <2, 3, -5> rgb <.5, .7, .9> }, in linear 16 bits.
#include "renderer/shading/lighting.h"
#include "tests/renderer/shading/lit_point.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isl::render::test {
namespace {

struct PovrayComponent {
  Vec3 centre;
  double radius, strength;

  [[nodiscard]] double field(const Vec3& p) const {
    const double rest = 1 - (p - centre).length2() / (radius * radius);
    return rest > 0 ? strength * rest * rest : 0;
  }
  [[nodiscard]] Vec3 gradient(const Vec3& p) const {
    const double rest = 1 - (p - centre).length2() / (radius * radius);
    return rest > 0 ? (p - centre) * (-4 * strength * rest / (radius * radius)) : Vec3(0);
  }
};

constexpr double kThreshold = 0.6;
const PovrayComponent kComponents[] = {{{-0.5, 0, 0}, 1.2, 1}, {{0.5, 0, 0}, 1.2, 1.5}, {{0, 1.2, -0.2}, 1, -0.7}};

double field(double z) {
  double sum = 0;
  for (const PovrayComponent& component : kComponents) sum += component.field({0, 0, z});
  return sum;
}

double surface_on_axis() {
  double outside = -1.2;
  double inside = 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (outside + inside) / 2;
    (field(middle) < kThreshold ? outside : inside) = middle;
  }
  return outside;
}

TEST(BlendedMaterial, is_the_mean_of_finished_colours) {
  scene::Database database;
  database.textures = {
      isl::test::plain_texture(database, {0.9, 0.1, 0.1},
                               {.ambient = {0.2, 0.2, 0.2}, .diffuse = 0.8, .phong = 0.5, .phong_size = 5}),
      isl::test::plain_texture(
          database, {0.1, 0.2, 0.9},
          {.ambient = {0.05, 0.05, 0.05}, .diffuse = 0.3, .brilliance = 2, .specular = 0.5, .roughness = 0.1}),
      isl::test::plain_texture(database, {0.1, 0.9, 0.2}, {.ambient = {0.1, 0.1, 0.1}, .diffuse = 0.6})};
  scene::Light light;
  light.location = {2, 3, -5};
  light.colour = {0.5, 0.7, 0.9};

  const Vec3 position(0, 0, surface_on_axis());
  Vec3 gradient(0);
  double total = 0;
  for (const PovrayComponent& component : kComponents) {
    gradient += component.gradient(position);
    total += std::abs(component.field(position));
  }
  const MaterialTable materials(database);
  std::vector<LitTexture> textures;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Material& material = materials[scene::TextureId(i)];
    textures.push_back(
        {&material, material.pigment, material.pigment, std::abs(kComponents[i].field(position)) / total});
  }
  const Vec3 view(0, 0, 1);
  const ShadingPoint point{position, turned_to_viewer(-gradient.normalized(), view), view, textures};
  const Rgb colour = ambient_colour(point) + lit_by(light, point);
  EXPECT_NEAR(colour.x * 65535, 16128, 2);
  EXPECT_NEAR(colour.y * 65535, 8714, 2);
  EXPECT_NEAR(colour.z * 65535, 16044, 2);
}

}  // namespace
}  // namespace isl::render::test
