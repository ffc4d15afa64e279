// Tests of the comparison itself, with the reference in the tracer's place: it must find no errors there, and must find
// those that are made on purpose.
#include "tests/reference/agreement.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isl::reference {
namespace {

/// The reference, rounded to what a tracer returns.
TraceBatch as_tracer(const ReferenceScene& scene) {
  return [&scene](std::span<const render::Ray> rays, std::span<render::Hit> hits) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto found = scene.first_hit(rays[i].origin, rays[i].direction, {.t_max = rays[i].t_max});
      hits[i] = {};
      if (!found) continue;
      hits[i].instance = 0;
      hits[i].t = static_cast<double>(found->crossing.t);
      hits[i].from_inside = !found->crossing.entering;
    }
  };
}

class AgreementSelf : public testing::Test {
 protected:
  AgreementSelf() {
    RandomSource random(21);
    for (int i = 0; i < 300; ++i) {
      const LineOfSight line = random_line(random, 3, 0.8);
      rays_.push_back({line.origin, line.direction, std::numeric_limits<double>::infinity(), 0, {}});
    }
    trace_(rays_, hits_);
  }

  /// Compares hits that were changed after tracing.
  Agreement compare() {
    const auto given = [this](std::span<const render::Ray>, std::span<render::Hit> hits) {
      std::copy(hits_.begin(), hits_.end(), hits.begin());
    };
    return compare_first_hits(scene_, given, rays_, options_);
  }

  scene::Database database_ =
      one_blob(gaussian(4), {point({0, 0, 0}, 0.6), point({0.8, 0, 0}, 0.3), point({0, 0.8, 0}, 0.2)});
  ReferenceScene scene_{database_};
  TraceBatch trace_ = as_tracer(scene_);
  std::vector<render::Ray> rays_;
  std::vector<render::Hit> hits_ = std::vector<render::Hit>(300);
  AgreementOptions options_{{1e-9, false}, 1e-3, 8};
};

TEST_F(AgreementSelf, FindsNothingWrongWithTheReference) {
  const Agreement agreement = compare();
  EXPECT_EQ(agreement.disagreements() + agreement.lost_in_rounding + agreement.too_thin, 0U) << agreement.text();
  EXPECT_GT(agreement.hits, 100U);
  EXPECT_LT(agreement.hits, 300U);
  EXPECT_LT(agreement.worst_depth, 1e-15L);
}

TEST_F(AgreementSelf, NoticesMissesInventionsAndMisplacedHits) {
  std::size_t missed = 0, invented = 0, misplaced = 0, reversed = 0;
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    if (hits_[i].is_miss() && i % 3 == 0) {
      hits_[i].instance = 0;
      hits_[i].t = 2;
      ++invented;
    } else if (!hits_[i].is_miss() && i % 3 == 0) {
      hits_[i] = {};
      ++missed;
    } else if (!hits_[i].is_miss() && i % 3 == 1) {
      hits_[i].t += 1e-6;
      ++misplaced;
    } else if (!hits_[i].is_miss()) {
      hits_[i].from_inside = true;
      ++reversed;
    }
  }
  const Agreement agreement = compare();
  EXPECT_EQ(agreement.missed, missed);
  EXPECT_EQ(agreement.invented, invented);
  EXPECT_EQ(agreement.misplaced, misplaced);
  EXPECT_EQ(agreement.reversed, reversed);
  EXPECT_EQ(agreement.listed.size(), options_.most_listed);
}

TEST_F(AgreementSelf, NamesEveryRayThatWasNotDecided) {
  const auto is_hit = [](const render::Hit& hit) { return !hit.is_miss(); };
  const auto right = std::find_if(hits_.begin(), hits_.end(), is_hit);
  const auto wrong = std::find_if(right + 1, hits_.end(), is_hit);
  ASSERT_NE(wrong, hits_.end());
  right->certainty = render::Certainty::undecided;
  *wrong = {};
  wrong->certainty = render::Certainty::undecided;
  const Agreement agreement = compare();
  EXPECT_EQ(agreement.flagged, 2U);
  EXPECT_EQ(agreement.wrong_flagged, 1U);
  ASSERT_EQ(agreement.listed_flagged.size(), 2U);
  EXPECT_TRUE(agreement.listed_flagged[0].starts_with("flagged: ray ")) << agreement.text();
  EXPECT_TRUE(agreement.listed_flagged[1].starts_with("flagged, wrong: ray ")) << agreement.text();
  EXPECT_TRUE(agreement.listed_flagged[1].ends_with("tracer a miss")) << agreement.text();
}

TEST_F(AgreementSelf, CountsPixelsOfTheWholePath) {
  options_.tolerance = {0.05, true};
  rays_.resize(1);
  rays_[0] = {{0, 0, -4.6}, {0, 0, 1}, std::numeric_limits<double>::infinity(), 16, {}};
  hits_.resize(1);
  trace_(rays_, hits_);
  ASSERT_FALSE(hits_[0].is_miss());
  const double pixel = 1e-3 * (16 + hits_[0].t);
  hits_[0].t += 0.04 * pixel;
  const Agreement near = compare();
  EXPECT_EQ(near.disagreements(), 0U);
  EXPECT_NEAR(static_cast<double>(near.worst_pixels), 0.04, 1e-9);
  hits_[0].t += 0.02 * pixel;
  EXPECT_EQ(compare().misplaced, 1U);
}

TEST(Agreement, ExcusesOnlyWhatDoublePrecisionCannotTell) {
  const scene::Database ball = one_blob(gaussian(4), {point({0, 0, 0}, 1)});
  const ReferenceScene scene(ball);
  const auto misses = [](std::span<const render::Ray>, std::span<render::Hit> hits) { hits[0] = {}; };
  const AgreementOptions options{{1e-9, false}, 1e-3, 8};
  const auto grazing = [](double depth) {
    return std::vector<render::Ray>{{{0, 1 - depth, -4}, {0, 0, 1}, std::numeric_limits<double>::infinity(), 0, {}}};
  };
  EXPECT_EQ(compare_first_hits(scene, misses, grazing(1e-15), options).lost_in_rounding, 1U);
  EXPECT_EQ(compare_first_hits(scene, misses, grazing(1e-12), options).missed, 1U);
  // At this tolerance the same ray's chord, 3e-6, is shorter than the length down to which a solver must search.
  const AgreementOptions coarse{{1e-2, false}, 1e-3, 8};
  EXPECT_EQ(compare_first_hits(scene, misses, grazing(1e-12), coarse).too_thin, 1U);
}

TEST(Agreement, NoticesWrongShadows) {
  const scene::Database ball = one_blob(gaussian(4), {point({0, 0, 0}, 1)});
  const ReferenceScene scene(ball);
  const std::vector<render::Ray> rays = {
      {{0, 0.5, -4}, {0, 0, 1}, 10, 0, {}}, {{0, 1.5, -4}, {0, 0, 1}, 10, 0, {}}, {{0, 0.5, -4}, {0, 0, 1}, 2, 0, {}}};
  const auto answers = [](const std::vector<std::uint8_t>& given) {
    return [given](std::span<const render::Ray>, std::span<std::uint8_t> out) {
      std::copy(given.begin(), given.end(), out.begin());
    };
  };
  EXPECT_EQ(compare_occlusions(scene, answers({1, 0, 0}), rays, {}).disagreements(), 0U);
  const Agreement wrong = compare_occlusions(scene, answers({0, 1, 1}), rays, {});
  EXPECT_EQ(wrong.missed, 1U);
  EXPECT_EQ(wrong.invented, 2U);
}

}  // namespace
}  // namespace isl::reference
