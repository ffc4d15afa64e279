// Mutated scenes through `check` and a tiny render, in this process. A few hundred are made from the scenes in this
// source tree, the same on every run; ISL_MUTATIONS sets the number.
#include "tests/fuzz/hostile_scene.h"
#include "tests/fuzz/mutated_scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace isl::test {
namespace {

TEST(Mutations, AreReadOrRefusedWithAPlaceAndDrawnInTime) {
  MutatedScenes scenes;
  const unsigned long count = std::stoul(setting("ISL_MUTATIONS", "500"));
  unsigned long accepted = 0, rendered = 0, slow = 0;
  for (unsigned long i = 0; i < count; ++i) {
    const std::string text = scenes.next();
    const SceneVerdict verdict = try_scene(text, scenes.origin().parent_path(), scenes.search_path(), i % 2 == 1);
    accepted += verdict.is_accepted;
    rendered += verdict.is_rendered;
    slow += verdict.is_slow;
    EXPECT_TRUE(verdict.trouble.empty()) << verdict.trouble << "made from " << scenes.origin() << ":\n" << text;
    EXPECT_FALSE(verdict.is_slow) << "more than " << kSecondsAllowed << " s, made from " << scenes.origin() << ":\n"
                                  << text;
  }
  fmt::print("{} scenes: {} accepted, {} rendered, {} slow\n", count, accepted, rendered, slow);
  // With too many mutations, nothing but the parser would be tested.
  EXPECT_GT(accepted, count / 10);
  EXPECT_GT(rendered, count / 20);
}

}  // namespace
}  // namespace isl::test
