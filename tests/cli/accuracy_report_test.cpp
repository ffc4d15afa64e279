// What is called better than what, from made-up measurements.
#include "cli/accuracy_report.h"

#include <gmock/gmock.h>

namespace isl::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Made {
  const char* name;
  double time, worst;
  std::uint64_t missed = 0;
};

/// The second is the default.
AccuracyReport report_of(const std::vector<Made>& made) {
  AccuracyReport report;
  for (const Made& one : made) {
    report.rungs.push_back({one.name, "", "family", report.rungs.size() == 1, {}});
    render::Measured& measured = report.comparison.settings.emplace_back();
    measured.relative_time = one.time;
    measured.summary.worst_pixels = one.worst;
    measured.summary.missed = one.missed;
  }
  return report;
}

TEST(ParetoFronts, HoldWhatNothingBeats) {
  const AccuracyReport report =
      report_of({{"quick", 0.5, 3}, {"default", 1, 0.05}, {"slow", 2, 1}, {"best", 4, 0.001}});
  EXPECT_THAT(pareto_front(report), ElementsAre(true, true, false, true));
}

TEST(ParetoFronts, LeaveOutWhatMissesMore) {
  EXPECT_THAT(pareto_front(report_of({{"slower", 1.5, 0, 3}, {"default", 1, 5}})), ElementsAre(false, true));
}

TEST(ParetoFronts, LetTheDefaultStandForItsEquals) {
  EXPECT_THAT(pareto_front(report_of({{"a", 0.999, 0}, {"default", 1, 0}, {"b", 1.001, 0}})),
              ElementsAre(false, true, false));
}

TEST(ParetoFronts, AreNeverEmpty) {
  // Each is as quick as the next, and the first is quicker than the last.
  const AccuracyReport report = report_of({{"a", 0.985, 0}, {"default", 1, 0}, {"b", 0.97, 0}, {"c", 0.955, 0}});
  const std::vector<bool> front = pareto_front(report);
  EXPECT_EQ(std::count(front.begin(), front.end(), true), 1);
}

TEST(Advice, NamesTheCheapestThatIsGoodEnough) {
  EXPECT_THAT(advice(report_of({{"quick", 0.5, 0.09}, {"default", 1, 0.001}})),
              HasSubstr("--solver quick is the cheapest"));
  EXPECT_THAT(advice(report_of({{"quick", 0.5, 0.11}, {"default", 1, 0.001}})),
              HasSubstr("--solver default (the default)"));
  EXPECT_THAT(advice(report_of({{"quick", 0.5, 0, 1}, {"default", 1, 0}})), HasSubstr("--solver default"));
  EXPECT_THAT(advice(report_of({{"quick", 0.5, 7}, {"default", 1, 7}})), HasSubstr("No setting"));
}

TEST(CheckSentences, SayLoudlyWhatIsRefuted) {
  EXPECT_THAT(check_sentence({.rays = 9, .proven = 8, .refuted = 1}), HasSubstr("1 WERE REFUTED"));
  EXPECT_THAT(check_sentence({.rays = 9, .proven = 8, .undecided = 1, .worst_pixels = 2e-9}),
              HasSubstr("8 of 9 sampled rays, to within 2e-09 px; 1 stayed undecided"));
}

}  // namespace
}  // namespace isl::cli
