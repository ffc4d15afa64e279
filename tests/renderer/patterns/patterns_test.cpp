// Properties of patterns that need no comparison with POV-Ray; their digits are compared in tests/povray/probes/.
#include "renderer/patterns/patterns.h"

#include "tests/support/patterns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <thread>

namespace isl::render {
namespace {

using scene::Database;
using scene::Pattern;
using scene::PatternKind;
using scene::Vec3;
using test::gradient_along;
using test::pattern_of;
using values::Environment;
using values::NoiseGenerator;

double value(const Pattern& pattern, const Vec3& p, const Database& database = {}) {
  Environment environment(NoiseGenerator::range_corrected);
  return Patterns(database).pattern_value(pattern, p, environment);
}

TEST(Patterns, CheckerChangesAcrossEveryFace) {
  const Pattern checker = pattern_of(PatternKind::checker);
  EXPECT_EQ(value(checker, {0.5, 0.5, 0.5}), 0);
  EXPECT_EQ(value(checker, {1.5, 0.5, 0.5}), 1);
  EXPECT_EQ(value(checker, {-0.5, 0.5, 0.5}), 1);
  EXPECT_EQ(value(checker, {-0.5, -0.5, 0.5}), 0);
  EXPECT_EQ(value(checker, {-1, 0, 0}), 1);
  EXPECT_EQ(value(checker, {-2, 1, 0}), 1);
  EXPECT_EQ(value(checker, {4503599627370495.0, 0, 0}), 1);
  EXPECT_EQ(value(checker, {-4503599627370497.0, 0, 0}), 1);
  EXPECT_EQ(value(checker, {9e15, 0, 0}), 0);
}

TEST(Patterns, HexagonsThatTouchDiffer) {
  const Pattern hexagon = pattern_of(PatternKind::hexagon);
  const double apart = std::sqrt(3.0);
  for (int q = -4; q <= 4; ++q) {
    for (int r = -4; r <= 4; ++r) {
      const Vec3 centre(1.5 * q, 0, apart * (r + q / 2.0));
      const double own = value(hexagon, centre);
      EXPECT_TRUE(own == 0 || own == 1 || own == 2);
      for (int side = 0; side < 6; ++side) {
        const double angle = (side + 0.5) * std::acos(-1.0) / 3;
        const Vec3 outward(std::cos(angle), 0, std::sin(angle));
        EXPECT_EQ(value(hexagon, centre + outward * (apart / 2 - 1e-6)), own);
        EXPECT_NE(value(hexagon, centre + outward * (apart / 2 + 1e-6)), own);
      }
    }
  }
}

TEST(Patterns, SixTrianglesMeetAtACorner) {
  std::set<double> around;
  for (int i = 0; i < 6; ++i) {
    const double angle = (i + 0.5) * std::acos(-1.0) / 3;
    around.insert(value(pattern_of(PatternKind::triangular), {0.1 * std::cos(angle), 0, 0.1 * std::sin(angle)}));
  }
  EXPECT_EQ(around, (std::set<double>{0, 1, 2, 3, 4, 5}));
}

TEST(Patterns, CrackleIsContinuousAndVanishesBetweenTwoPoints) {
  const Pattern crackle = pattern_of(PatternKind::crackle);
  double least = 1, before = value(crackle, {-3, 0.3, 0.4});
  for (int i = 1; i <= 6000; ++i) {
    const double now = value(crackle, {-3 + i * 0.001, 0.3, 0.4});
    EXPECT_LE(std::abs(now - before), 0.0021);  // both distances change at most as fast as the point
    least = std::min(least, now);
    before = now;
  }
  EXPECT_LT(least, 0.002);
}

TEST(Patterns, AWaveIsAppliedAfterFrequencyAndPhase) {
  Pattern gradient = gradient_along({1, 0, 0});
  gradient.frequency = 2;
  gradient.phase = 0.25;
  EXPECT_NEAR(value(gradient, {0.25, 0, 0}), 0.75, 1e-12);
  gradient.wave = scene::Wave::triangle;
  EXPECT_NEAR(value(gradient, {0.25, 0, 0}), 0.5, 1e-12);
  gradient.wave = scene::Wave::sine;
  EXPECT_NEAR(value(gradient, {0.25, 0, 0}), 0, 1e-12);
}

TEST(Patterns, OneItselfStaysOne) { EXPECT_EQ(value(gradient_along({1, 0, 0}), {1, 0, 0}), 1); }

TEST(Patterns, InfinitiesAndNansDoNoHarm) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double odd[] = {kInfinity, -kInfinity, std::nan(""), 1e300, -1e300};
  for (std::size_t i = 0; i < scene::kPatternKindCount; ++i) {
    const auto kind = PatternKind(i);
    const bool refers = info_of(kind).block != PatternBlock::none;  // to a record that is not here
    if (refers && info_of(kind).block != PatternBlock::optional) continue;
    for (const double x : odd) static_cast<void>(value(pattern_of(kind), {x, 0.5, x}));
  }
  for (const int sides : {3, 4, 6}) {
    Pattern pavement = pattern_of(PatternKind::pavement);
    std::get<scene::Operands>(pavement.operands).set("number_of_sides", sides);
    for (const double x : odd) static_cast<void>(value(pavement, {x, 0.5, x}));
  }
  for (const int number : {1, 12, 25, 26, 27}) {
    Pattern tiling = pattern_of(PatternKind::tiling);
    std::get<scene::Operands>(tiling.operands).set("number", number);
    for (const double x : odd) static_cast<void>(value(tiling, {x, 0.5, x}));
  }
  Database database;
  database.pigment_maps = {{{0, {{0.25}}}, {1, {{0.5}}}}};
  database.pigments.resize(1);
  database.pigments[0].pattern = pattern_of(PatternKind::onion);
  database.pigments[0].map = scene::PigmentMapId{0};
  Environment environment(NoiseGenerator::range_corrected);
  EXPECT_EQ(Patterns(database).pigment_colour({.pattern = scene::PigmentId{0}}, Vec3(std::nan("")), environment).red,
            0.5);
}

class Inside final : public PatternSurroundings {
 public:
  [[nodiscard]] bool is_inside(const scene::Object& object, const Vec3& point, StepCounter&) const override {
    return object.shape == 7 && point.length() < 1;
  }
  [[nodiscard]] double field_of(const scene::Object&, const Vec3& point, StepCounter&) const override {
    return 2 - point.length();
  }
};

TEST(Patterns, AnObjectIsOneWithinAndZeroWithout) {
  Database database;
  database.pattern_objects.resize(1);
  database.pattern_objects[0].shape = 7;
  const Inside inside;
  const Patterns patterns(database, &inside);
  Environment environment(NoiseGenerator::range_corrected);
  const Pattern object = pattern_of(PatternKind::object, scene::ObjectOperands{0});
  EXPECT_EQ(patterns.pattern_value(object, {0.5, 0.5, 0.5}, environment), 1);
  EXPECT_EQ(patterns.pattern_value(object, {0.5, 0.5, 0.9}, environment), 0);
}

TEST(Patterns, AFunctionAsAPatternMayBeAPatternItself) {
  Database database;
  scene::Function function;
  function.body = scene::PatternFunction{pattern_of(PatternKind::checker)};
  function.frame_size = 3;
  database.functions.push_back(std::make_shared<const scene::Function>(function));
  const Patterns patterns(database);
  Environment environment(NoiseGenerator::range_corrected, {}, &patterns);
  const Pattern pattern = pattern_of(PatternKind::function, scene::FunctionOperands{scene::FunctionId{0}});
  EXPECT_EQ(patterns.pattern_value(pattern, {1.5, 0.5, 0.5}, environment), 1);
  EXPECT_EQ(patterns.pattern_value(pattern, {0.5, 0.5, 0.5}, environment), 0);
}

TEST(Patterns, ACountOfStepsEndsThem) {
  Database database;
  database.pigment_maps = {{{0, {.pattern = scene::PigmentId{1}}}}, {{0, {{0.5}}}}};
  database.pigments.resize(2);
  for (std::uint32_t i = 0; i < 2; ++i) {
    database.pigments[i].pattern = pattern_of(PatternKind::bozo);
    database.pigments[i].map = scene::PigmentMapId{i};
  }
  const Patterns patterns(database);
  Environment enough(NoiseGenerator::range_corrected, {.steps_at_point = 3});
  Environment too_few(NoiseGenerator::range_corrected, {.steps_at_point = 1});
  EXPECT_EQ(patterns.pigment_colour({.pattern = scene::PigmentId{0}}, Vec3(0), enough).red, 0.5);
  EXPECT_FALSE(enough.is_spent());
  static_cast<void>(patterns.pigment_colour({.pattern = scene::PigmentId{0}}, Vec3(0), too_few));
  EXPECT_TRUE(too_few.is_spent());
}

TEST(Patterns, AStoppedRunEndsThem) {
  Database database;
  // Each map has the one before twice: 2^60 looks in all.
  database.pigment_maps.resize(60);
  database.pigments.resize(60);
  for (std::uint32_t i = 0; i < 60; ++i) {
    database.pigments[i].pattern = pattern_of(PatternKind::average);
    database.pigments[i].map = scene::PigmentMapId{i};
    const scene::Pigment next = i + 1 < 60 ? scene::Pigment{.pattern = scene::PigmentId{i + 1}} : scene::Pigment{{0.5}};
    database.pigment_maps[i] = {{1, next}, {1, next}};
  }
  StopFlag stop;
  stop.set(StopReason::interrupt);
  Environment environment(NoiseGenerator::range_corrected, {.stop = &stop});
  static_cast<void>(Patterns(database).pigment_colour({.pattern = scene::PigmentId{0}}, Vec3(0), environment));
  EXPECT_TRUE(environment.is_spent());
}

TEST(Patterns, ThreadsMayShareThem) {
  const Database database;
  const Patterns patterns(database);
  double sums[2] = {0, 0};
  const auto add_up = [&](double& sum) {
    Environment environment(NoiseGenerator::range_corrected);
    for (const PatternKind kind : {PatternKind::waves, PatternKind::cells, PatternKind::granite}) {
      for (int i = 0; i < 200; ++i) sum += patterns.pattern_value(pattern_of(kind), {i * 0.1, 0.2, 0.3}, environment);
    }
  };
  std::thread other(add_up, std::ref(sums[0]));
  add_up(sums[1]);
  other.join();
  EXPECT_EQ(sums[0], sums[1]);
}

}  // namespace
}  // namespace isl::render
