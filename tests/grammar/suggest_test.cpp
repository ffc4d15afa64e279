#include "grammar/suggest.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <string>

namespace isl::grammar {
namespace {

constexpr std::size_t kFar = 100;
constexpr std::array<std::string_view, 5> kWords{"sphere", "cylinder", "torus", "box", "colour"};

TEST(EditDistance, CountsEachKindOfSlipOnce) {
  EXPECT_EQ(edit_distance("torus", "torus", kFar), 0u);
  EXPECT_EQ(edit_distance("torus", "tours", kFar), 1u) << "swapped";
  EXPECT_EQ(edit_distance("torus", "tors", kFar), 1u) << "left out";
  EXPECT_EQ(edit_distance("torus", "torrus", kFar), 1u) << "put in";
  EXPECT_EQ(edit_distance("torus", "tarus", kFar), 1u) << "replaced";
  EXPECT_EQ(edit_distance("", "abc", kFar), 3u);
  EXPECT_EQ(edit_distance("ca", "abc", kFar), 3u) << "no letter is touched twice";
}

TEST(EditDistance, StopsCountingAtTheLimit) { EXPECT_EQ(edit_distance("aaaaaa", "bbbbbb", 2), 3u); }

RC_GTEST_PROP(EditDistance, IsSymmetricAndAtMostTheLongerLength, ()) {
  const auto letters = rc::gen::container<std::string>(rc::gen::element('a', 'b', 'c'));
  const std::string a = *letters, b = *letters;
  const std::size_t distance = edit_distance(a, b, kFar);
  RC_ASSERT(distance == edit_distance(b, a, kFar));
  RC_ASSERT(distance <= std::max(a.size(), b.size()));
  RC_ASSERT((distance == 0) == (a == b));
}

TEST(Closest, FindsTheNearestWord) {
  EXPECT_EQ(closest("spehre", kWords), "sphere");
  EXPECT_EQ(closest("cilynder", kWords), "cylinder");
}

TEST(Closest, FindsWordsThatDifferInCase) { EXPECT_EQ(closest("BOX", kWords), "box"); }

TEST(Closest, ProposesNothingForWordsThatAreFar) {
  EXPECT_EQ(closest("superellipsoid", kWords), std::nullopt);
  EXPECT_EQ(closest("ab", kWords), std::nullopt) << "two letters are similar to any word";
  EXPECT_EQ(closest("fog", kWords), std::nullopt) << "half of three letters differ";
}

TEST(Closest, NeverProposesTheWordItself) {
  constexpr std::array<std::string_view, 1> kSame{"sphere"};
  EXPECT_EQ(closest("sphere", kSame), std::nullopt);
}

}  // namespace
}  // namespace isl::grammar
