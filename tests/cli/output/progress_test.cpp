#include "cli/output/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isl::cli {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;
using testing::Not;

TEST(Progress, TellsTheTimeLeftFromWhatIsDone) {
  EXPECT_THAT(progress_line(0.5, seconds(30)), HasSubstr(" 50 %  0:30 left"));
  EXPECT_THAT(progress_line(0.1, seconds(10)), HasSubstr("1:30 left"));
  EXPECT_THAT(progress_line(0.5, seconds(7200)), HasSubstr("2:00:00 left"));
}

TEST(Progress, GuessesNothingFromNothing) {
  EXPECT_THAT(progress_line(0, seconds(5)), Not(HasSubstr("left")));
  EXPECT_THAT(progress_line(0, seconds(5)), HasSubstr("  0 %"));
}

TEST(Progress, StaysInItsBar) {
  EXPECT_EQ(progress_line(2, seconds(1)).find("####] 100 %"), progress_line(1, seconds(1)).find("####] 100 %"));
  EXPECT_EQ(progress_line(-1, seconds(1)), progress_line(0, seconds(1)));
  EXPECT_LT(progress_line(0.999, seconds(86400)).size(), 80u);
}

}  // namespace
}  // namespace isl::cli
