// Comparisons in the report (which setting is better than which), on made-up measurements.
#include "cli/accuracy/report.h"

#include <gmock/gmock.h>

namespace isl::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Made {
  const char* setting;
  double time, worst;
  std::uint64_t missed = 0;
};

AccuracyReport report_of(const std::vector<Made>& made) {
  AccuracyReport report;
  for (const Made& one : made) {
    report.rungs.push_back({parse_setting(one.setting).value(), {}});
    render::Measured& measured = report.comparison.settings.emplace_back();
    measured.relative_time = one.time;
    measured.summary.worst_pixels = one.worst;
    measured.summary.missed = one.missed;
  }
  return report;
}

TEST(ParetoFronts, HoldWhatNothingBeats) {
  const AccuracyReport report =
      report_of({{"paper:2", 0.5, 3}, {"hermite", 1, 0.05}, {"lg", 2, 1}, {"exact", 4, 0.001}});
  EXPECT_THAT(pareto_front(report), ElementsAre(true, true, false, true));
}

TEST(ParetoFronts, LeaveOutWhatMissesMore) {
  EXPECT_THAT(pareto_front(report_of({{"lg", 1.5, 0, 3}, {"hermite", 1, 5}})), ElementsAre(false, true));
}

TEST(ParetoFronts, LetTheDefaultStandForItsEquals) {
  EXPECT_THAT(pareto_front(report_of({{"march", 0.999, 0}, {"hermite", 1, 0}, {"climb", 1.001, 0}})),
              ElementsAre(false, true, false));
}

TEST(ParetoFronts, AreNeverEmpty) {
  // Each setting is as quick as the next within the spread, and the first is quicker than the last.
  const AccuracyReport report =
      report_of({{"march", 0.985, 0}, {"hermite", 1, 0}, {"climb", 0.97, 0}, {"sphere", 0.955, 0}});
  const std::vector<bool> front = pareto_front(report);
  EXPECT_EQ(std::count(front.begin(), front.end(), true), 1);
}

TEST(Advice, NamesTheCheapestThatIsGoodEnough) {
  EXPECT_THAT(advice(report_of({{"paper:2", 0.5, 0.09}, {"hermite", 1, 0.001}})),
              HasSubstr("--solver paper:2 is the cheapest"));
  EXPECT_THAT(advice(report_of({{"paper:2", 0.5, 0.11}, {"hermite", 1, 0.001}})),
              HasSubstr("--solver hermite (the default)"));
  EXPECT_THAT(advice(report_of({{"paper:2", 0.5, 0, 1}, {"hermite", 1, 0}})), HasSubstr("--solver hermite"));
  EXPECT_THAT(advice(report_of({{"paper:2", 0.5, 7}, {"hermite", 1, 7}})), HasSubstr("No setting"));
}

TEST(SolverSettings, AreNamedAsTheyAreRead) {
  for (const char* name : {"hermite 0.1px", "march:0.2px", "paper:2,plain", "sphere:1.5 1e-06px", "exact"}) {
    EXPECT_EQ(parse_setting(name).value().name(), name);
  }
  EXPECT_EQ(parse_setting("hermite 0.1px").value().options(), "--solver hermite --tolerance 0.1px");
  EXPECT_EQ(parse_setting("paper:2,plain").value().family(), "paper");
  EXPECT_TRUE(parse_setting("hermite 0.05px").value().is_default());
  EXPECT_FALSE(parse_setting("hermite 0.04px").value().is_default());
  EXPECT_THAT(parse_setting("hermit").message(), HasSubstr("did you mean `hermite`"));
  EXPECT_FALSE(parse_setting("hermite little").ok());
}

TEST(ParetoFronts, TakeWhatDoublesCannotTellApartAsEqual) {
  AccuracyReport report = report_of({{"exact", 1.5, 1e-13}, {"hermite", 1, 2e-13}});
  EXPECT_THAT(pareto_front(report), ElementsAre(true, true));
  report.comparison.reference.worst_pixels = 4e-14;
  EXPECT_THAT(pareto_front(report), ElementsAre(false, true));
}

TEST(ReferenceSentences, SayHowMuchIsKnown) {
  EXPECT_EQ(reference_sentence({.rays = 9, .proven = 9, .worst_pixels = 2e-14}),
            "The truth was proven in extended precision, independently of all solvers, on 9 of 9 rays, to within 2e-14 "
            "px.");
  EXPECT_THAT(reference_sentence({.rays = 9, .proven = 6, .trusted = 2, .undecided = 1}),
              HasSubstr("6 of 9 rays; 2 meet a solid or a combination, whose place is taken from `exact`; 1 touch a "
                        "surface and are left undecided."));
}

}  // namespace
}  // namespace isl::cli
