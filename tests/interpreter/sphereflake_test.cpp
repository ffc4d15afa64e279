// The script of the paper's scene against the same construction in C++.
#include "tests/support/sphereflake.h"
#include "tests/interpreter/evaluated_text.h"

#include <gtest/gtest.h>

namespace isl::test {
namespace {

EvaluatedText flake(double levels) {
  interpreter::EvaluateOptions options;
  options.defines = {{"Levels", levels}};
  return EvaluatedText(EvaluatedText::File{"scenes/paper/sphereflake.isl"}, options);
}

TEST(Sphereflake, HasTheRightNumberOfBalls) {
  std::size_t expected = 0, power = 1;
  for (int levels = 0; levels <= 4; ++levels, power *= 9) {
    expected += power;
    const EvaluatedText scene = flake(levels);
    ASSERT_EQ(scene.messages(), "");
    ASSERT_EQ(scene.database().blobs.size(), 1u);
    EXPECT_EQ(scene.database().blobs[0].components.size(), expected);
  }
}

TEST(Sphereflake, IsTheSameAsTheOneMadeWithoutTheLanguage) {
  const scene::Database expected = sphereflake(3, {scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 4});
  const EvaluatedText scene = flake(3);
  ASSERT_EQ(scene.messages(), "");
  const auto& found = scene.database().blobs.at(0).components;
  const auto& wanted = expected.blobs.at(0).components;
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LT((found[i].a - wanted[i].a).length(), 1e-12) << i;
    EXPECT_NEAR(found[i].radius_a, wanted[i].radius_a, 1e-15) << i;
    const scene::Colour& a = scene.database().texture(found[i].texture).pigment.colour;
    const scene::Colour& b = expected.texture(wanted[i].texture).pigment.colour;
    EXPECT_NEAR(a.red, b.red, 1e-15) << i;
  }
}

TEST(Sphereflake, ABallTakesLessThan200Bytes) {
  const EvaluatedText scene = flake(4);
  const scene::Blob& blob = scene.database().blobs.at(0);
  const std::size_t bytes = blob.components.capacity() * sizeof(scene::Component) +
                            blob.origins.capacity() * sizeof(OriginId) + scene.origins().memory_bytes();
  EXPECT_LT(static_cast<double>(bytes) / static_cast<double>(blob.components.size()), 200);
}

TEST(Sphereflake, EachBallKnowsTheCallsThatMadeIt) {
  const EvaluatedText scene = flake(2);
  const GrowingArray<OriginId>& origins = scene.database().blobs.at(0).origins;
  ASSERT_EQ(origins.size(), 91u);
  EXPECT_EQ(scene.origins().resolve(origins.front()).chain.size(), 1u);
  EXPECT_EQ(scene.origins().resolve(origins.back()).chain.size(), 3u);
  EXPECT_EQ(scene.origins().resolve(origins.back()).chain[0].name, "Flake");
}

}  // namespace
}  // namespace isl::test
