// Rays that double precision does not decide, which the product answers in extended numbers of its own
// (renderer/extended). A judge that shared these would share their mistakes. So its verdict on the product's answers is
// asked, and on the same answers made wrong: moved, or as they are if the ray's side is mistaken.
#include "tests/reference/rounding_rule.h"
#include "tests/reference/scale_cases.h"
#include "tests/reference/tracer_under_test.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <iostream>
#include <optional>
#include <utility>

namespace isl::reference {
namespace {

/// Seeds with many such rays, of every kind of extreme.
constexpr std::uint64_t kSeeds[] = {495, 1615, 2749, 2773, 2903, 2979, 802103, 810431, 820897};
constexpr int kLines = 100;

struct Told {
  int told = 0, all = 0;

  void count(bool is_told) {
    told += is_told ? 1 : 0;
    ++all;
  }
  [[nodiscard]] double share() const { return all > 0 ? static_cast<double>(told) / all : 0; }
};

bool is_refuted(Verdict verdict) { return verdict != Verdict::agrees && verdict != Verdict::undecided; }

TEST(ExtendedAnswers, AreRightAndWouldBeToldIfTheyWereWrong) {
  Told agreeing, moved, of_other_side;
  for (const std::uint64_t seed : kSeeds) {
    const SeededScaleCase seeded = seeded_scale_case(seed, kLines);
    render::TracerOptions options;
    options.pixel_angle = seeded.made.pixel_angle;
    const TracerUnderTest tracer(seeded.made.database, options);
    const RoundingRule rule(seeded.made.database);
    std::optional<double> somewhere;  // a place next to the detail
    for (const render::Ray& ray : camera_rays(seeded.made.lines)) {
      const std::uint64_t before = tracer.uncertified_steps();
      const render::Hit hit = tracer.hit(ray);
      if (!hit.is_miss()) somewhere = hit.t;
      if (tracer.uncertified_steps() == before || hit.certainty != render::Certainty::certified) continue;
      const auto found = hit.is_miss() ? std::nullopt : std::optional(hit.t);
      const Verdict verdict = rule.judge(ray, found).verdict;
      EXPECT_FALSE(is_refuted(verdict)) << "seed " << seed;
      agreeing.count(verdict == Verdict::agrees);
      if (found) {
        for (const double factor : {1 - 1e-6, 1 + 1e-6})
          moved.count(is_refuted(rule.judge(ray, *found * factor).verdict));
        of_other_side.count(is_refuted(rule.judge(ray, std::nullopt).verdict));
      } else if (somewhere) {
        of_other_side.count(is_refuted(rule.judge(ray, somewhere).verdict));
      }
    }
  }
  for (const auto& [what, counts] :
       {std::pair{"agreeing", agreeing}, {"moved", moved}, {"of the other side", of_other_side}})
    std::cout << what << ": " << counts.told << " of " << counts.all << '\n';
  EXPECT_GT(agreeing.all, 50) << "rays that need more digits";
  EXPECT_GT(agreeing.share(), 0.9);
  EXPECT_GT(moved.share(), 0.9);
  EXPECT_GT(of_other_side.share(), 0.9);
}

}  // namespace
}  // namespace isl::reference
