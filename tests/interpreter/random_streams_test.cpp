#include "interpreter/random_streams.h"

#include <gtest/gtest.h>

namespace isl::interpreter {
namespace {

TEST(RandomStreams, GiveThePublishedSequence) {
  RandomStreams random;
  const double stream = random.open(1);
  EXPECT_NEAR(*random.next(stream), 0.421992875, 5e-10);
  EXPECT_NEAR(*random.next(stream), 0.487121198, 5e-10);
  EXPECT_NEAR(*random.next(stream), 0.665896216, 5e-10);
}

TEST(RandomStreams, DoNotDisturbOneAnother) {
  RandomStreams random;
  const double a = random.open(5), b = random.open(5);
  const double first = *random.next(a);
  static_cast<void>(random.next(a));
  EXPECT_EQ(*random.next(b), first);
}

TEST(RandomStreams, KnowOnlyWhatWasOpened) {
  RandomStreams random;
  EXPECT_FALSE(random.next(0));
  static_cast<void>(random.open(1));
  EXPECT_FALSE(random.next(1));
  EXPECT_FALSE(random.next(-1));
  EXPECT_FALSE(random.next(0.0 / 0.0));
}

}  // namespace
}  // namespace isl::interpreter
