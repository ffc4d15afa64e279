#include "tests/renderer/integrator/rendered_text.h"

#include "renderer/film/camera.h"
#include "tests/interpreter/evaluated_text.h"

#include <gtest/gtest.h>

namespace isl::test {

render::RenderResult rendered(std::string_view scene, int size, render::RenderOptions options) {
  render::ImageLibrary images({});
  interpreter::EvaluateOptions reading;
  reading.images = &images;
  const EvaluatedText text(scene, reading);
  EXPECT_EQ(text.messages(), "") << scene;
  scene::Database database = text.database();
  leave_out(render::plan_of(database, {.without = options.without}), database);
  EXPECT_TRUE(render::plan_of(database).refused.empty()) << scene;
  options.width = options.height = size;
  if (!options.samples && !options.max_noise) options.samples = 1;
  if (options.threads == 0) options.threads = 1;
  render::TracerOptions tracing;
  tracing.pixel_angle = render::pixel_angle(database.camera.value_or(scene::Camera{}), size, size);
  return render::render(database, render::Tracer(database, tracing), options);
}

render::Rgb middle_of(const render::Image& image) {
  const std::size_t middle = 4 * image.window.index(image.full_width / 2, image.full_height / 2);
  return {image.rgba[middle], image.rgba[middle + 1], image.rgba[middle + 2]};
}

}  // namespace isl::test
