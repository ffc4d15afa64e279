// The direction and the handedness of cameras, compared with what POV-Ray 3.7 draws. Each line of cameras_of_povray.txt
// has a version, a camera, and the directions of the rays through three corner pixels of a picture of 8 by 6, which
// were read from the colours of POV-Ray's picture of a sphere around the camera.
#include "tests/interpreter/evaluated_text.h"
#include "tests/support/source_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>
#include <string>

namespace isl::test {
namespace {

using scene::Vec3;

constexpr int kWidth = 8, kHeight = 6;

struct Row {
  std::string version, camera;
  std::array<Vec3, 3> rays;
};

std::vector<Row> rows() {
  std::ifstream file(std::string(ISL_SOURCE_DIR) + "/tests/interpreter/cameras_of_povray.txt");
  std::vector<Row> result;
  for (std::string line; std::getline(file, line);) {
    const std::size_t first = line.find(" | "), second = line.find(" | ", first + 3);
    Row row{line.substr(0, first), line.substr(first + 3, second - first - 3), {}};
    std::istringstream numbers(line.substr(second + 3));
    for (Vec3& ray : row.rays) numbers >> ray.x >> ray.y >> ray.z;
    EXPECT_FALSE(numbers.fail()) << line;
    result.push_back(row);
  }
  return result;
}

/// The ray through the middle of a pixel, of length 1.
Vec3 ray_through(const scene::Camera& camera, int x, int y) {
  const double u = (x + 0.5) / kWidth - 0.5, v = 0.5 - (y + 0.5) / kHeight;
  return (camera.direction + camera.right * u + camera.up * v).normalized();
}

interpreter::EvaluateOptions options_of(int width, int height, bool is_size_known = false) {
  interpreter::EvaluateOptions options;
  options.image_width = width;
  options.image_height = height;
  options.is_size_known = is_size_known;
  return options;
}

TEST(Camera, LooksWherePovrayLooksAndShowsTheSameHand) {
  const std::vector<Row> all = rows();
  ASSERT_GT(all.size(), 200u);
  for (const Row& row : all) {
    const EvaluatedText scene("#version " + row.version + ";\n" + row.camera, options_of(kWidth, kHeight));
    ASSERT_TRUE(scene.database().camera) << row.camera << "\n" << scene.messages();
    const scene::Camera& camera = *scene.database().camera;
    const std::array<Vec3, 3> found = {ray_through(camera, 0, 0), ray_through(camera, kWidth - 1, 0),
                                       ray_through(camera, 0, kHeight - 1)};
    // The colours have 16 bits for 2.2 units, and the table three digits.
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_LT((found[i] - row.rays[i]).length(), 0.002) << row.version << " " << row.camera << ", ray " << i;
  }
}

// ---- The picture's shape --------------------------------------------------------------------------------------------

TEST(Camera, WithoutRightFollowsThePicturesShape) {
  const auto right = [](std::string_view text, int width, int height) {
    return EvaluatedText(text, options_of(width, height)).database().camera->right.length();
  };
  EXPECT_DOUBLE_EQ(right("camera { }", 800, 600), 1.33) << "what POV-Ray has";
  EXPECT_DOUBLE_EQ(right("camera { }", 1920, 1080), 1.33 * 4 / 3);
  EXPECT_DOUBLE_EQ(right("camera { fisheye }", 300, 300), 1.33 * 3 / 4);
  EXPECT_DOUBLE_EQ(right("#declare C = camera { location x } camera { C }", 300, 300), 1.33 * 3 / 4);
  EXPECT_DOUBLE_EQ(right("camera { right 2*x }", 300, 300), 2);
}

TEST(Camera, KeepsItsAngleAcrossThePictureInEveryShape) {
  for (const int height : {100, 300, 600}) {
    const EvaluatedText scene("camera { angle 90 }", options_of(600, height));
    const scene::Camera& camera = *scene.database().camera;
    EXPECT_NEAR(camera.direction.length(), camera.right.length() / 2, 1e-12);
  }
}

TEST(Camera, IsWarnedOfWhereItsRightDoesNotFitThePicture) {
  const auto messages = [](std::string_view text, int width, int height) {
    return EvaluatedText(text, options_of(width, height, true)).messages();
  };
  EXPECT_EQ(
      messages("camera { right -4/3*x }", 1920, 1080),
      "warning: the picture is stretched: `right` is 1.333 times as long as `up`, but the picture is 1.778 times as "
      "wide as high\n");
  EXPECT_EQ(messages("camera { right 16/9*x }", 800, 600).substr(0, 33), "warning: the picture is stretched");
  EXPECT_EQ(messages("camera { up 2*y }", 800, 600).substr(0, 33), "warning: the picture is stretched");
  EXPECT_EQ(messages("camera { right 1.33*x }", 800, 600), "") << "two decimals of 4/3";
  EXPECT_EQ(messages("camera { right 1.78*x }", 853, 480), "") << "and of 16/9, in whole pixels";
  EXPECT_EQ(messages("camera { right -x*image_width/image_height }", 1234, 77), "");
  EXPECT_EQ(messages("camera { spherical right 4/3*x }", 200, 100), "") << "only its angles count";
  EXPECT_EQ(messages("camera { }", 1920, 1080), "");
  EXPECT_EQ(EvaluatedText("camera { right 4/3*x }", options_of(1920, 1080)).messages(), "") << "no size is known";
}

TEST(Camera, IsToldWhichRightFits) {
  const auto hint = [](std::string_view text) {
    const EvaluatedText scene(text, options_of(200, 100, true));
    return scene.sink().diagnostics().empty() ? "" : scene.sink().diagnostics()[0].hint;
  };
  EXPECT_EQ(hint("camera { right <-4/3, 0, 0> }"), "`right -x*image_width/image_height` fits every picture");
  EXPECT_EQ(hint("camera { up 3*z right 4*y direction x }"), "`right 3*y*image_width/image_height` fits every picture");
  EXPECT_EQ(hint("camera { right <1, 0, 1> }"), "a `right` of length 1*image_width/image_height fits every picture");
}

}  // namespace
}  // namespace isl::test
