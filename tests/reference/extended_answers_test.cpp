// What double precision does not decide, the product decides in extended numbers of its own (renderer/extended), and
// the judge judges. A judge that shared them would share their mistakes.
#include "renderer/extended/root_search.h"
#include "renderer/reference/reference_tracer.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/rounding_rule.h"
#include "tests/reference/scale_cases.h"
#include "tests/reference/tracer_under_test.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <iostream>
#include <numeric>
#include <optional>
#include <vector>

namespace isl::reference {
namespace {

/// The sign of F after a start, and the first place where it changes.
struct Beginning {
  bool starts_inside, is_certain;
  std::optional<long double> crossing;
};

Beginning by_product(const scene::Database& database, const LineOfSight& line, bool starts_on_root) {
  const scene::Blob& blob = database.blobs.front();
  std::vector<std::uint32_t> numbers(blob.components.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  render::RaySteps steps;
  const extended::Line ray{extended::interval_of(line.origin), extended::interval_of(line.direction)};
  extended::FieldOnRay field(database, blob, numbers, ray, steps);
  const extended::FirstRoot root = extended::first_root(field, {.starts_on_root = starts_on_root});
  return {root.starts_inside, root.touches.empty() && !steps.is_spent(), root.crossing};
}

/// All rays of random blobs, asked of the extended numbers themselves, which the tracer asks for few of them: from
/// afar, and on from the surface.
TEST(ExtendedNumbers, FindTheCrossingsOfTheJudge) {
  RandomSource random(61);
  int compared = 0, crossings = 0, undecided = 0;
  const auto compare = [&](const scene::Database& database, const LineOfSight& line, bool starts_on_root) {
    const ReferenceField field(database, database.blobs.front());
    const Line ray{interval_of(line.origin), interval_of(line.direction)};
    const RayRoots known = roots_along(field, ray, {.starts_on_root = starts_on_root, .first_only = true});
    const Beginning found = by_product(database, line, starts_on_root);
    if (!known.touches.empty() || !found.is_certain) {
      ++undecided;
      return found.crossing;
    }
    ++compared;
    EXPECT_EQ(found.starts_inside, known.starts_inside);
    EXPECT_EQ(found.crossing.has_value(), !known.crossings.empty());
    if (!found.crossing || known.crossings.empty()) return found.crossing;
    ++crossings;
    const Crossing& crossing = known.crossings.front();
    const long double off = std::abs(*found.crossing - crossing.t) - crossing.slack - 0x1p-58L * crossing.t;
    // Where the ray grazes the surface, F is within its rounding before and behind it.
    const Interval there = FieldOnRay(field, ray).at(*found.crossing).value;
    EXPECT_TRUE(off <= 0 || there.mignitude() <= 4 * there.radius()) << static_cast<double>(off);
    return found.crossing;
  };
  for (int blob = 0; blob < 90; ++blob) {
    const RandomBlobOptions options{.components = 1 + random.below(12),
                                    .half_space = blob % 3 == 0,
                                    .convolutions = blob % 4 != 0,
                                    .hardest = blob % 2 == 0 ? 8.0 : 300.0};
    const scene::Database database = random_blob(random, options);
    for (const LineOfSight& line : random_lines(random, 24, 3, 0.7)) {
      SCOPED_TRACE(testing::Message() << "blob " << blob << ", ray from " << line.origin << " along "
                                      << line.direction);
      const std::optional<long double> first = compare(database, line, false);
      if (!first) continue;
      const scene::Vec3 start = line.origin + line.direction * static_cast<double>(*first);
      compare(database, {start, line.direction}, true);
    }
  }
  std::cout << compared << " compared, " << crossings << " crossings, " << undecided << " undecided\n";
  EXPECT_GT(crossings, 1500);
  EXPECT_LT(undecided, compared / 100);
}

/// Every answer on which the tracer has asked for extended numbers, and that is certain.
struct ExtendedAnswers {
  std::vector<render::Ray> rays;
  std::vector<render::Hit> hits;

  ExtendedAnswers(const TracerUnderTest& tracer, const std::vector<render::Ray>& asked) {
    for (const render::Ray& ray : asked) {
      const std::uint64_t before = tracer.uncertified_steps();
      const render::Hit hit = tracer.hit(ray);
      if (tracer.uncertified_steps() == before || hit.certainty != render::Certainty::certified) continue;
      rays.push_back(ray);
      hits.push_back(hit);
    }
  }
};

/// As the tests of scales judge. An answer that is moved may still be right there, to eight units of coordinates 10¹⁵
/// times as large; one of the other side is not.
TEST(ExtendedNumbers, AnswerRaysOfEveryScaleAndWouldBeToldIfTheyWereOnTheOtherSide) {
  constexpr int kRaysOfSeed = 100;
  int agreeing = 0, told = 0, all = 0, other_side = 0;
  const auto is_refuted = [](Verdict verdict) { return verdict != Verdict::agrees && verdict != Verdict::undecided; };
  // Seeds with many such rays, of every kind of extreme.
  for (const std::uint64_t seed : {495, 1615, 2749, 2773, 2903, 2979, 802103, 810431, 820897}) {
    const SeededScaleCase seeded = seeded_scale_case(seed, kRaysOfSeed);
    render::TracerOptions options;
    options.pixel_angle = seeded.made.pixel_angle;
    const TracerUnderTest tracer(seeded.made.database, options);
    const ExtendedAnswers answers(tracer, camera_rays(seeded.made.lines));
    const RoundingRule rule(seeded.made.database);
    for (std::size_t i = 0; i < answers.rays.size(); ++i) {
      const render::Hit& hit = answers.hits[i];
      const auto found = hit.is_miss() ? std::nullopt : std::optional(hit.t);
      const Verdict verdict = rule.judge(answers.rays[i], found).verdict;
      EXPECT_FALSE(is_refuted(verdict)) << "seed " << seed << ", ray " << i;
      agreeing += verdict == Verdict::agrees ? 1 : 0;
      ++all;
      if (!found) continue;
      ++other_side;
      told += is_refuted(rule.judge(answers.rays[i], std::nullopt).verdict) ? 1 : 0;
    }
  }
  std::cout << "agreeing: " << agreeing << " of " << all << ", told: " << told << " of " << other_side << '\n';
  EXPECT_GT(all, 500) << "rays that need more digits";
  EXPECT_GT(agreeing, all * 9 / 10);
  EXPECT_GT(told, other_side * 9 / 10);
}

}  // namespace
}  // namespace isl::reference
