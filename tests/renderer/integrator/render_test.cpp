// Whole pictures, compared with closed forms and with the same pictures made in other ways.
#include "renderer/render.h"
#include "tests/renderer/integrator/picture_scene.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace isl::render::test {
namespace {

using scene::SolidKind;

RenderOptions small(int width = 70, int height = 50) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  return options;
}

RenderResult rendered(const scene::Database& database, const RenderOptions& options) {
  return render(database, Tracer(database, {}), options);
}

std::array<double, 4> pixel(const Image& image, int x, int y) {
  const double* value = &image.rgba[4 * image.window.index(x, y)];
  return {value[0], value[1], value[2], value[3]};
}

/// A unit sphere at the origin, seen along z from −4, with a light at `light`.
scene::Database lit_sphere(const Vec3& light, double diffuse) {
  scene::Database database;
  database.settings.assumed_gamma = 1.0;
  database.camera = scene::Camera{{0, 0, -4}, {0, 0, 1}, {1.2, 0, 0}, {0, 0.9, 0}};
  database.lights.emplace_back();
  database.lights[0].location = light;
  add_solid(database, {SolidKind::sphere, false, {0, 0, 0}, Vec3(0), 1, 0}, {1, 1, 1},
            {.ambient = {}, .diffuse = diffuse});
  return database;
}

Aovs surface_and_samples() {
  Aovs aovs{&samples_aov()};
  for (const SurfaceAov& row : surface_aovs()) aovs.push_back(&row.aov);
  return aovs;
}

TEST(Render, a_lit_sphere_is_lamberts_law) {
  const Vec3 light(3, 5, -6);
  RenderOptions options = small();
  options.samples = 1;
  const Image image = rendered(lit_sphere(light, 0.75), options).image;
  int lit = 0;
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 70; ++x) {
      const double across = ((x + 0.5) / 70 - 0.5) * 1.2;
      const double up = (0.5 - (y + 0.5) / 50) * 0.9;
      const Vec3 direction = Vec3(across, up, 1).normalized();
      // |−4z + t d| = 1
      const double b = -4 * direction.z;
      const double rest = b * b - 15;
      double expected = 0;
      if (rest > 0) {
        const Vec3 normal = Vec3(0, 0, -4) + direction * (-b - std::sqrt(rest));
        expected = 0.75 * std::max(0.0, normal.dot((light - normal).normalized()));
      }
      lit += expected > 0 ? 1 : 0;
      EXPECT_NEAR(pixel(image, x, y)[1], expected, 1e-12) << x << ", " << y;
    }
  }
  EXPECT_GT(lit, 500);
}

TEST(Render, a_white_furnace_is_white) {
  scene::Database database;
  database.settings.assumed_gamma = 1.0;
  database.settings.background = {1, 1, 1};
  database.camera = scene::Camera{{0, 0, -4}, {0, 0, 1}, {1.2, 0, 0}, {0, 0.9, 0}};
  add_solid(database, {SolidKind::cone, false, {0, -1, 0}, {0, 1, 0}, 1, 0}, {1, 1, 1},
            {.ambient = {1, 1, 1}, .diffuse = 0});
  const RenderResult result = rendered(database, small());
  for (const double value : result.image.rgba) ASSERT_EQ(value, 1);
  EXPECT_EQ(result.statistics.paths.shadow, 0u);
  EXPECT_EQ(result.statistics.samples_per_pixel, 1) << "nothing differs, so nothing is refined";
}

TEST(Render, is_the_same_whatever_the_threads_and_the_order_of_tiles) {
  const scene::Database database = povray_solids();
  for (const std::optional<int> samples : {std::optional<int>(), std::optional<int>(3)}) {
    RenderOptions options = small(150, 110);
    options.samples = samples;
    options.aovs = surface_and_samples();
    options.threads = 1;
    const RenderResult reference = rendered(database, options);
    for (const int threads : {1, 2, 5}) {
      for (const TileOrder order : {TileOrder::rows, TileOrder::reversed, TileOrder::shuffled}) {
        options.threads = threads;
        options.tile_order = order;
        const RenderResult other = rendered(database, options);
        EXPECT_EQ(other.image.rgba, reference.image.rgba);
        ASSERT_EQ(other.image.layers.size(), 6u);
        for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(other.image.layers[i].values, reference.image.layers[i].values);
        EXPECT_EQ(other.statistics.paths.shadow, reference.statistics.paths.shadow);
        EXPECT_EQ(other.statistics.counters.cells, reference.statistics.counters.cells);
      }
    }
  }
}

TEST(Render, a_crop_is_that_part_of_the_whole) {
  const scene::Database database = povray_solids();
  RenderOptions options = small(100, 75);
  options.aovs = surface_and_samples();
  const Image whole = rendered(database, options).image;
  options.crop = PixelRect{37, 20, 81, 200};
  const Image part = rendered(database, options).image;
  EXPECT_EQ(part.window, (PixelRect{37, 20, 81, 75}));
  for (int y = 20; y < 75; ++y) {
    for (int x = 37; x < 81; ++x) {
      ASSERT_EQ(pixel(part, x, y), pixel(whole, x, y)) << x << ", " << y;
      for (const char* layer : {"depth", "samples"}) {
        ASSERT_EQ(part.layer(layer)->at(part.window.index(x, y), 0),
                  whole.layer(layer)->at(whole.window.index(x, y), 0));
      }
    }
  }
}

TEST(Render, refines_edges_only_and_never_beyond_sixteen) {
  RenderOptions options = small();
  options.aovs = {&samples_aov()};
  const RenderResult result = rendered(lit_sphere({0, 0, -100}, 1), options);
  std::uint64_t rays = 0;
  for (const double count : result.image.layer("samples")->values) {
    EXPECT_TRUE(count == 1 || count == 16);
    rays += static_cast<std::uint64_t>(count);
  }
  EXPECT_EQ(rays, result.statistics.paths.camera);
  const auto count_at = [&](int x, int y) {
    return result.image.layer("samples")->at(result.image.window.index(x, y), 0);
  };
  EXPECT_EQ(count_at(0, 0), 1) << "background";
  EXPECT_EQ(count_at(35, 25), 1) << "the middle of the sphere";
  EXPECT_GT(result.statistics.samples_per_pixel, 1.1);
  EXPECT_LT(result.statistics.samples_per_pixel, 4);
}

TEST(Render, fully_sampled_pixels_are_those_of_sixteen_samples) {
  const scene::Database database = povray_solids();
  RenderOptions options = small();
  options.aovs = {&samples_aov()};
  const Image adaptive = rendered(database, options).image;
  options.samples = 16;
  const Image full = rendered(database, options).image;
  int refined = 0;
  for (std::size_t i = 0; i < adaptive.window.area(); ++i) {
    ASSERT_EQ(full.layer("samples")->at(i, 0), 16);
    if (adaptive.layer("samples")->at(i, 0) != 16) continue;
    ++refined;
    for (std::size_t k = 0; k < 4; ++k) ASSERT_EQ(adaptive.rgba[4 * i + k], full.rgba[4 * i + k]);
  }
  EXPECT_GT(refined, 100);
}

TEST(Render, traces_exactly_the_samples_asked_for) {
  RenderOptions options = small(33, 21);
  options.samples = 5;
  const RenderResult result = rendered(povray_solids(), options);
  EXPECT_EQ(result.statistics.paths.camera, 33u * 21u * 5u);
}

TEST(Render, antialiasing_of_an_edge_is_its_coverage) {
  // A white half-space fills the picture from 30.25 pixels down.
  scene::Database database;
  database.settings.assumed_gamma = 1.0;
  database.camera = scene::Camera{{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  const double edge = 0.5 - 30.25 / 50;
  add_solid(database, {SolidKind::cylinder, false, {0, edge - 10, 0}, {0, edge, 0}, 5, 5}, {1, 1, 1},
            {.ambient = {1, 1, 1}, .diffuse = 0});
  database.camera->location = {0, edge, -10};
  // Seen edge-on, the cap is a line at the height of the eye: rows above it are black, rows below are white.
  database.camera->direction = {0, -edge, 1};
  const Image image = rendered(database, small()).image;
  EXPECT_EQ(pixel(image, 35, 29)[0], 0);
  EXPECT_NEAR(pixel(image, 35, 30)[0], 0.75, 1.0 / 16);
  EXPECT_EQ(pixel(image, 35, 31)[0], 1);
}

TEST(Render, quality_takes_away_shadows_then_light) {
  // The light stands behind an occluder that the camera does not see.
  scene::Database database = lit_sphere({0, 0, -20}, 0.5);
  add_solid(database, {SolidKind::sphere, false, {0, 0, -10}, Vec3(0), 2, 0}, {1, 1, 1}, {});
  database.textures[0] =
      isl::test::plain_texture(database, {0.8, 0.8, 0.8}, {.ambient = {0.1, 0.1, 0.1}, .diffuse = 0.5});
  RenderOptions options = small(3, 3);
  options.samples = 1;
  const auto middle = [&](int quality) {
    options.quality = quality;
    return pixel(rendered(database, options).image, 1, 1)[0];
  };
  for (const int quality : {0, 1}) EXPECT_EQ(middle(quality), 0.8);
  for (const int quality : {2, 3}) EXPECT_NEAR(middle(quality), 0.8 * 0.1 + 0.8 * 0.5, 1e-12);
  for (const int quality : {4, 9}) EXPECT_NEAR(middle(quality), 0.8 * 0.1, 1e-12);
}

TEST(Render, an_object_without_shadow_lets_light_through) {
  scene::Database database = lit_sphere({0, 0, -20}, 0.5);
  add_solid(database, {SolidKind::sphere, false, {0, 0, -10}, Vec3(0), 2, 0}, {1, 1, 1}, {});
  database.objects[1].no_shadow = true;
  RenderOptions options = small(3, 3);
  options.samples = 1;
  EXPECT_NEAR(pixel(rendered(database, options).image, 1, 1)[0], 0.5, 1e-12);
}

TEST(Render, with_alpha_the_background_is_transparent) {
  scene::Database database = lit_sphere({0, 0, -100}, 1);
  database.settings.background = {0.3, 0.4, 0.5};
  RenderOptions options = small(21, 15);
  options.aa = 0.1;
  const std::array<double, 4> opaque = pixel(rendered(database, options).image, 0, 0);
  EXPECT_EQ(opaque, (std::array<double, 4>{0.3, 0.4, 0.5, 1}));
  options.alpha = true;
  const Image image = rendered(database, options).image;
  EXPECT_EQ(pixel(image, 0, 0), (std::array<double, 4>{0, 0, 0, 0}));
  EXPECT_EQ(pixel(image, 10, 7)[3], 1);
  const bool has_soft_edge = [&] {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
      if (image.rgba[i] > 0 && image.rgba[i] < 1) return true;
    }
    return false;
  }();
  EXPECT_TRUE(has_soft_edge);
}

TEST(Render, a_transmitting_background_is_dimmed) {
  scene::Database database;
  database.settings.assumed_gamma = 1.0;
  database.settings.background = {0.2, 0.4, 0.6, 0.3, 0.5};
  const Image image = rendered(database, small(1, 1)).image;
  EXPECT_EQ(pixel(image, 0, 0), (std::array<double, 4>{0.1, 0.2, 0.3, 1})) << "as POV-Ray's rgbt <.2, .4, .6, .5>";
}

TEST(Render, keeps_the_layers_asked_for) {
  RenderOptions options = small(3, 3);
  options.aovs = surface_and_samples();
  const Image image = rendered(lit_sphere({0, 0, -100}, 1), options).image;
  constexpr std::size_t kMiddle = 4;
  EXPECT_EQ(image.layer("depth")->at(kMiddle, 0), 3);
  EXPECT_EQ(image.layer("position")->at(kMiddle, 2), -1);
  EXPECT_EQ(image.layer("normal")->at(kMiddle, 2), -1);
  EXPECT_EQ(image.layer("albedo")->at(kMiddle, 0), 1);
  EXPECT_EQ(image.layer("primitive")->at(kMiddle, 0), 0);
  EXPECT_TRUE(std::isinf(image.layer("depth")->at(0, 0)));
  EXPECT_EQ(image.layer("primitive")->at(0, 0), 0xFFFFFFFFu);
  options.aovs = {};
  EXPECT_TRUE(rendered(lit_sphere({0, 0, -100}, 1), options).image.layers.empty());
}

TEST(Render, tells_its_progress_and_ends_at_one) {
  std::vector<double> told;
  RenderOptions options = small(200, 150);
  options.progress = [&](double share) { told.push_back(share); };
  EXPECT_TRUE(rendered(povray_solids(), options).complete);
  ASSERT_GT(told.size(), 5u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GT(told.front(), 0);
  EXPECT_EQ(told.back(), 1);
}

TEST(Render, stops_when_told_and_returns_what_is_done) {
  StopFlag stop;
  RenderOptions options = small(200, 150);
  options.threads = 1;
  options.run.stop = &stop;
  options.progress = [&](double share) {
    if (share > 0.1) stop.set(StopReason::interrupt);
  };
  const RenderResult result = rendered(povray_solids(), options);
  EXPECT_FALSE(result.complete);
  const std::size_t done = static_cast<std::size_t>(
      std::count_if(result.image.rgba.begin(), result.image.rgba.end(), [](double value) { return value != 0; }));
  EXPECT_GT(done, 0u);
  EXPECT_LT(done, result.image.rgba.size());
  EXPECT_EQ(result.image.rgba.size(), 4u * 200u * 150u);
}

TEST(Render, an_empty_crop_is_an_empty_picture) {
  RenderOptions options = small();
  options.crop = PixelRect{500, 500, 600, 600};
  const RenderResult result = rendered(povray_solids(), options);
  EXPECT_TRUE(result.image.rgba.empty());
  EXPECT_EQ(result.statistics.paths.camera, 0u);
}

}  // namespace
}  // namespace isl::render::test
