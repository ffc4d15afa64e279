// The positions of samples, the pixels that get them, and the order in which pixels are visited.
#include "renderer/film/adaptive.h"
#include "renderer/film/camera.h"
#include "renderer/film/sample_pattern.h"
#include "renderer/film/tiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace isl::render::test {
namespace {

TEST(SamplePattern, begins_at_the_centre_and_visits_every_row_and_column_once) {
  for (const int count : {1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 64, 100, 255, 1024}) {
    const std::vector<SampleOffset> offsets = sample_pattern(count);
    ASSERT_EQ(offsets.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(offsets[0].x, 0);
    EXPECT_EQ(offsets[0].y, 0);
    std::set<long> columns, rows;
    for (const SampleOffset& offset : offsets) {
      EXPECT_TRUE(-0.5 <= offset.x && offset.x < 0.5 && -0.5 <= offset.y && offset.y < 0.5);
      columns.insert(std::lround(offset.x * count));
      rows.insert(std::lround(offset.y * count));
    }
    EXPECT_EQ(columns.size(), offsets.size());
    EXPECT_EQ(rows.size(), offsets.size());
  }
}

TEST(SamplePattern, of_16_keeps_its_points_apart) {
  const std::vector<SampleOffset> offsets = sample_pattern(16);
  double nearest = 1;
  for (std::size_t i = 1; i < offsets.size(); ++i) {
    const double x = offsets[i].x, y = offsets[i].y;
    nearest = std::min(nearest, std::hypot(x, y));
  }
  EXPECT_NEAR(nearest, std::sqrt(10.0) / 16, 1e-12)
      << "the greatest distance in a 16-point lattice with an odd generator";
}

TEST(Tiles, cover_every_pixel_once_in_any_order) {
  const PixelRect rect{5, 3, 101, 70};
  for (const TileOrder order : {TileOrder::rows, TileOrder::reversed, TileOrder::shuffled}) {
    std::vector<int> seen(rect.area());
    std::vector<Pixel> pixels;
    for (const PixelRect& tile : tiles_of(rect, order)) {
      pixels_of(tile, pixels);
      for (const Pixel& pixel : pixels) {
        ASSERT_TRUE(pixel.x >= rect.x0 && pixel.x < rect.x1 && pixel.y >= rect.y0 && pixel.y < rect.y1);
        ++seen[rect.index(pixel.x, pixel.y)];
      }
    }
    for (const int count : seen) ASSERT_EQ(count, 1);
  }
  EXPECT_TRUE(tiles_of({4, 4, 4, 9}, TileOrder::rows).empty());
}

TEST(Tiles, are_shuffled_when_asked) {
  const PixelRect rect{0, 0, 320, 320};
  EXPECT_NE(tiles_of(rect, TileOrder::shuffled), tiles_of(rect, TileOrder::rows));
}

/// Adds one sample a pixel, with linear greys.
void add_greys(const std::vector<double>& greys, Film& film) {
  constexpr double kOpaque[] = {1};
  for (std::size_t i = 0; i < greys.size(); ++i) film.add_samples(i, std::array{Rgb(greys[i])}, kOpaque);
}

bool rough(const std::vector<double>& greys, int x, int y, double threshold) {
  const PixelRect rect{0, 0, 3, 3};
  Film film(rect, {});
  add_greys(greys, film);
  DisplayedPass displayed(rect);
  for (int row = 0; row < 3; ++row) displayed.fill_row(film, row);
  return displayed.is_rough(x, y, threshold);
}

TEST(Adaptive, compares_with_all_eight_neighbours) {
  for (std::size_t i = 0; i < 9; ++i) {
    std::vector<double> greys(9, 0.2);
    greys[i] = 0.9;
    EXPECT_TRUE(rough(greys, 1, 1, 0.1));
  }
  EXPECT_FALSE(rough(std::vector<double>(9, 0.2), 1, 1, 0));
  EXPECT_TRUE(rough(std::vector<double>(9, 0.2), 1, 1, -1)) << "a negative threshold takes every pixel";
}

TEST(Adaptive, judges_what_a_display_shows) {
  // In linear light 0 and 0.02 are close; on a display they are codes 0 and 0.15.
  std::vector<double> dark(9, 0.0);
  dark[0] = 0.02;
  EXPECT_TRUE(rough(dark, 1, 1, 0.1));
  EXPECT_FALSE(rough(dark, 2, 2, 0.1)) << "not a neighbour";
  std::vector<double> glaring(9, 3.0);
  glaring[0] = 300;
  EXPECT_FALSE(rough(glaring, 1, 1, 0.1)) << "both are white";
}

TEST(Camera, puts_pixel_centres_where_povray_does) {
  const scene::Camera camera{{0, 0, 0}, {0, 0, 1}, {4, 0, 0}, {0, 3, 0}};
  const CameraRays rays(camera, 4, 3);
  RecurringAngles angles;
  // The ray through a pixel's centre meets z = 1 in whole and half units, as POV-Ray's pictures of a gradient there
  // show.
  const Vec3 first = rays.through(0.5, 0.5, angles).direction;
  EXPECT_NEAR(first.x / first.z, -1.5, 1e-15);
  EXPECT_NEAR(first.y / first.z, 1.0, 1e-15);
  const Vec3 last = rays.through(3.5, 2.5, angles).direction;
  EXPECT_NEAR(last.x / last.z, 1.5, 1e-15);
  EXPECT_NEAR(last.y / last.z, -1.0, 1e-15);
  EXPECT_NEAR(first.length(), 1, 1e-15);
}

/// The direction of the ray through pixel (12, 3) of 16 by 12.
Vec3 direction_of(scene::CameraKind kind, double angle_degrees, double width, int cylinder_type = 0) {
  scene::Camera camera{.right = {width, 0, 0}, .kind = kind, .cylinder_type = cylinder_type};
  camera.angle = angle_degrees * std::numbers::pi / 180;
  camera.vertical_angle = camera.angle / 2;
  RecurringAngles angles;
  return CameraRays(camera, 16, 12).through(12.5, 3.5, angles).direction;
}

void expect_direction(const Vec3& found, const Vec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 6e-5) << i;
}

TEST(Camera, has_povrays_projections) {
  using scene::CameraKind;
  // Measured in POV-Ray 3.7 to four digits.
  expect_direction(direction_of(CameraKind::perspective, 0, 4 / 3.), {.3446, .1915, .9190});
  expect_direction(direction_of(CameraKind::fisheye, 180, 1), {.7160, .5304, .4540});
  expect_direction(direction_of(CameraKind::ultra_wide_angle, 120, 4 / 3.), {.5469, .3164, .7751});
  expect_direction(direction_of(CameraKind::omnimax, 180, 1), {.6756, .5005, .5414});
  expect_direction(direction_of(CameraKind::panoramic, 0, 1), {.6133, .6088, .5033});
  expect_direction(direction_of(CameraKind::cylinder, 180, 1, 1), {.7568, .2040, .6211});
  expect_direction(direction_of(CameraKind::cylinder, 180, 1, 2), {.2707, .5860, .7637});
  expect_direction(direction_of(CameraKind::cylinder, 180, 1, 3), {.7730, 0, .6344});
  expect_direction(direction_of(CameraKind::cylinder, 180, 1, 4), {0, .6088, .7934});
  expect_direction(direction_of(CameraKind::spherical, 360, 1), {.7781, .6088, -.1548});
  const scene::Camera parallel{.location = {1, 2, 3}, .right = {4, 0, 0}, .kind = CameraKind::orthographic};
  RecurringAngles angles;
  const Ray ray = CameraRays(parallel, 16, 12).through(12.5, 3.5, angles);
  EXPECT_EQ(ray.origin, Vec3(1 + 4 * .28125, 2 + .5 - 3.5 / 12, 3));
  EXPECT_EQ(ray.direction, Vec3(0, 0, 1));
}

TEST(Camera, shows_nothing_beyond_a_fisheyes_circle) {
  const CameraRays rays({.kind = scene::CameraKind::fisheye, .angle = 3}, 10, 10);
  RecurringAngles angles;
  EXPECT_EQ(rays.through(.5, .5, angles).direction, Vec3(0));
}

TEST(Camera, does_not_depend_on_the_angles_that_are_remembered) {
  using scene::CameraKind;
  for (const CameraKind kind :
       {CameraKind::ultra_wide_angle, CameraKind::panoramic, CameraKind::cylinder, CameraKind::spherical}) {
    const CameraRays rays({.kind = kind, .cylinder_type = 1, .angle = 2, .vertical_angle = 1}, 2000, 1000);
    RecurringAngles shared;  // more rows and columns than it can remember
    for (int i = 0; i < 4000; ++i) {
      const double x = i * 7 % 2000 + 0.5, y = i * 3 % 1000 + 0.5;
      RecurringAngles fresh;
      ASSERT_EQ(rays.through(x, y, shared).direction, rays.through(x, y, fresh).direction) << x << ", " << y;
    }
  }
}

TEST(Camera, knows_the_angle_of_a_pixel) {
  EXPECT_NEAR(pixel_angle({{0, 0, 0}, {0, 0, 2}, {4, 0, 0}, {0, 3, 0}}, 400, 100), 0.005, 1e-15);
}

}  // namespace
}  // namespace isl::render::test
