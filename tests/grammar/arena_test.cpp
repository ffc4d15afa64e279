#include "grammar/arena.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace isl::grammar {
namespace {

TEST(Arena, KeepsEarlierObjectsWhereTheyAreWhenItGrows) {
  Arena arena;
  std::vector<const std::uint64_t*> made;
  for (std::uint64_t i = 0; i < 100'000; ++i) made.push_back(arena.create(i));
  for (std::uint64_t i = 0; i < made.size(); ++i) EXPECT_EQ(*made[i], i);
}

TEST(Arena, AlignsEachObject) {
  struct alignas(32) Wide {
    char bytes[32];
  };
  Arena arena;
  for (int i = 0; i < 100; ++i) {
    static_cast<void>(arena.create('c'));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(arena.create(Wide{})) % 32, 0u);
  }
}

TEST(Arena, HoldsWhatIsLargerThanABlock) {
  Arena arena;
  const std::string text(1'000'000, 'a');
  EXPECT_EQ(arena.copy_text(text), text);
}

TEST(Arena, CopiesNothingOfAnEmptyList) {
  Arena arena;
  EXPECT_TRUE(arena.copy(std::vector<int>{}).empty());
}

}  // namespace
}  // namespace isl::grammar
