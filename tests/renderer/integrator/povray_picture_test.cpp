// The renderer agrees with POV-Ray 3.7 on the camera, the lighting, the solids and the blob; see povray_solids.pov and
// povray_blob.pov.
#include "renderer/render.h"
#include "tests/renderer/integrator/picture_scene.h"
#include "tests/renderer/integrator/povray_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

namespace isl::render::test {
namespace {

/// `tolerance` is in units of 16 bits.
void expect_pixels(const scene::Database& database, std::span<const PovrayPixel> pixels, double tolerance) {
  const Tracer tracer(database, {});
  RenderOptions options;
  options.width = 64;
  options.height = 48;
  options.samples = 1;
  const Image image = render(database, tracer, options).image;
  for (const PovrayPixel& expected : pixels) {
    const double* value = &image.rgba[4 * image.window.index(expected.x, expected.y)];
    const int channels[] = {expected.red, expected.green, expected.blue};
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(std::min(value[i], 1.0) * 65535, channels[i], tolerance)
          << "channel " << i << " at " << expected.x << ", " << expected.y;
    }
  }
}

// POV-Ray keeps colours in single precision and rounds them, which is one unit of 16 bits.
TEST(PovrayPicture, of_solids_agrees_pixel_by_pixel) { expect_pixels(povray_solids(), kPovraySolids, 1.01); }

TEST(PovrayPicture, of_a_blob_agrees_pixel_by_pixel) { expect_pixels(povray_blob(), kPovrayBlob, 1.01); }

}  // namespace
}  // namespace isl::render::test
