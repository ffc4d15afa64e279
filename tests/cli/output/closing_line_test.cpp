#include "cli/output/closing_line.h"

#include <gtest/gtest.h>

namespace isl::cli {
namespace {

render::Image picture(int width, int height) {
  render::Image image;
  image.full_width = width;
  image.full_height = height;
  image.window = {0, 0, width, height};
  return image;
}

TEST(ClosingLine, NamesTheFilesTheSizeAndTheTime) {
  EXPECT_EQ(closing_line({"coral_tree.png"}, picture(800, 600), 1.9449), "isl: coral_tree.png, 800x600, 1.94 s");
  EXPECT_EQ(closing_line({"a.png", "b.exr"}, picture(4, 3), 0.001), "isl: a.png, b.exr, 4x3, 0.00 s");
  EXPECT_EQ(closing_line({"a.png"}, picture(4, 3), 4321.9), "isl: a.png, 4x3, 4322 s");
}

TEST(ClosingLine, TellsTheSizeOfACropAndOfTheWhole) {
  render::Image image = picture(800, 600);
  image.window = {100, 50, 300, 150};
  EXPECT_EQ(closing_line({"a.png"}, image, 1), "isl: a.png, 200x100 of 800x600, 1.00 s");
}

TEST(ClosingLine, IsOneLineWhateverTheName) {
  EXPECT_EQ(closing_line({"a\x1b[2J.png"}, picture(4, 3), 1), "isl: a\\x1b[2J.png, 4x3, 1.00 s");
}

}  // namespace
}  // namespace isl::cli
