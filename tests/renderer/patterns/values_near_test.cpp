// Values that a kind finds for several points together are those that it finds alone, to the last bit.
#include "renderer/patterns/kinds/waveform.h"
#include "renderer/patterns/patterns.h"

#include "tests/support/patterns.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace isl::render {
namespace {

using scene::Database;
using scene::Operands;
using scene::Pattern;
using scene::PatternKind;
using scene::Vec3;
using test::pattern_of;
using values::Environment;
using values::NoiseGenerator;

using Settings = std::vector<std::pair<const char*, std::variant<double, int>>>;

Pattern pattern_with(PatternKind kind, const Settings& settings) {
  Pattern pattern = pattern_of(kind);
  for (const auto& setting : settings) {
    auto& operands = std::get<Operands>(pattern.operands);
    std::visit([&](auto value) { operands.set(setting.first, value); }, setting.second);
  }
  return pattern;
}

/// How many values of each pattern are compared.
constexpr int kPlaces = 2000;

/// Points around p as bumps ask for them, and now and then farther away.
std::array<Vec3, 5> points_around(const Vec3& p, double distance, std::mt19937& random) {
  std::uniform_real_distribution<double> along(-1, 1);
  std::array<Vec3, 5> points;
  for (Vec3& point : points) point = p + Vec3(along(random), along(random), along(random)).normalized() * distance;
  return points;
}

void expect_same(const Pattern& pattern, const std::string& name) {
  SCOPED_TRACE(name);
  const PatternInfo& info = info_of(pattern.kind);
  ASSERT_NE(info.values_near, nullptr);
  const Database database;
  const Patterns patterns(database);
  const PatternWorld world{database, patterns, nullptr, 0, nullptr};
  Environment environment(NoiseGenerator::range_corrected);
  std::mt19937 random(31);
  std::uniform_real_distribution<double> place(-4, 4), exponent(-8, 0.5);
  for (int i = 0; i < kPlaces; ++i) {
    const Vec3 p(place(random), place(random), place(random));
    const std::array<Vec3, 5> points = points_around(p, std::pow(10, exponent(random)), random);
    std::array<double, 5> values{};
    info.values_near({pattern, p, environment, world}, points, values);
    for (std::size_t k = 0; k < points.size(); ++k)
      ASSERT_EQ(values[k], info.value({pattern, points[k], environment, world})) << i << " " << k;
  }
}

TEST(ValuesNear, CrackleIsThatOfEachPoint) {
  for (const double metric : {1.0, 2.0, 3.0}) {
    for (const double offset : {0.0, 0.3}) {
      Pattern crackle = pattern_with(PatternKind::crackle, {{"metric", metric}, {"offset", offset}});
      expect_same(crackle, "metric " + std::to_string(metric) + ", offset " + std::to_string(offset));
      std::get<Operands>(crackle.operands).set("form", Vec3(0, 0, 0.6));
      expect_same(crackle, "the third point");
    }
  }
}

TEST(ValuesNear, FractalsAreThoseOfEachPoint) {
  for (const int magnet : {0, 1, 2}) {
    for (const double iterations : {1.0, 17.0, 600.0}) {
      expect_same(pattern_with(PatternKind::fractal, {{"magnet", magnet}, {"iterations", iterations}}),
                  "magnet " + std::to_string(magnet) + ", iterations " + std::to_string(iterations));
    }
  }
}

TEST(ValuesNear, PavementIsThatOfEachPoint) {
  for (const int sides : {3, 4, 6}) {
    for (const int number : {1, 2}) {
      expect_same(pattern_with(PatternKind::pavement,
                               {{"number_of_sides", sides}, {"number_of_tiles", 3}, {"pattern", number}}),
                  "sides " + std::to_string(sides) + ", polyform " + std::to_string(number));
    }
  }
}

TEST(ValuesNear, InfinitiesAndNansDoNoHarm) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Database database;
  const Patterns patterns(database);
  const PatternWorld world{database, patterns, nullptr, 0, nullptr};
  Environment environment(NoiseGenerator::range_corrected);
  for (std::size_t i = 0; i < scene::kPatternKindCount; ++i) {
    const auto kind = PatternKind(i);
    if (info_of(kind).values_near == nullptr) continue;
    const Pattern pattern = pattern_of(kind);
    for (const double x : {kInfinity, -kInfinity, std::nan(""), 1e300, -1e300}) {
      const Vec3 p(x, 0.5, x);
      std::array<double, 4> values{};
      info_of(kind).values_near({pattern, p, environment, world}, std::array{p, Vec3(0), p, Vec3(1, x, 2)}, values);
    }
  }
}

/// The remainder of values beyond 1 is fmod's, to the last bit.
TEST(Waves, AreThoseOfTheRemainder) {
  std::mt19937_64 random(32);
  std::uniform_real_distribution<double> exponent(-3, 12), sign(-1, 1);
  Pattern pattern = test::gradient_along({1, 0, 0});
  pattern.phase = 0;
  for (int i = 0; i < 200000; ++i) {
    double value = std::copysign(std::pow(10, exponent(random)), sign(random));
    if (i % 4 == 0) {  // beside a multiple of the modulus
      value = std::floor(std::abs(value)) * 1.00001;
      if (i % 8 == 0) value = std::nextafter(value, i % 16 == 0 ? 0 : std::numeric_limits<double>::infinity());
    }
    double known = std::fmod(value, 1.00001);
    if (known < 0) known -= std::floor(known);
    ASSERT_EQ(in_wave(value, pattern), known) << value;
  }
}

}  // namespace
}  // namespace isl::render
