// What is certain stays certain at every scale: detail over extent from 10⁻⁶ to 10⁻¹⁵, for every kernel with every
// skeleton, and for every solver that is called certified. No hit may be missed, invented, or farther off than eight
// units in the last place of the coordinates (rounding_rule.h).
#include "tests/reference/rounding_rule.h"
#include "tests/reference/scale_cases.h"
#include "tests/reference/small_scenes.h"
#include "tests/reference/tracer_under_test.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <string>

namespace isl::reference {
namespace {

constexpr int kExponents[] = {6, 9, 12, 15};
constexpr int kLines = 12;

struct Certified {
  const char* name;
  render::SolverName solver;
  bool packets = true;
};
constexpr Certified kCertified[] = {
    {"hermite", render::SolverName::hermite}, {"hermite_single", render::SolverName::hermite, false},
    {"exact", render::SolverName::exact},     {"interval", render::SolverName::interval},
    {"lg", render::SolverName::lg},           {"inclusion", render::SolverName::inclusion},
};

struct Counts {
  int rays = 0, hits = 0, undecided = 0, wrong[3] = {};  ///< missed, invented, misplaced
  long double worst = 0;                                 ///< of the misplaced: |F| over what is allowed

  [[nodiscard]] int all_wrong() const { return wrong[0] + wrong[1] + wrong[2]; }
  void operator+=(const Counts& other) {
    rays += other.rays;
    hits += other.hits;
    undecided += other.undecided;
    for (int i = 0; i < 3; ++i) wrong[i] += other.wrong[i];
    worst = std::max(worst, other.worst);
  }
};

Counts counts_of(const scene::Database& database, const std::vector<render::Ray>& rays,
                 const render::TracerOptions& options) {
  const RoundingRule rule(database);
  const std::vector<render::Hit> hits = TracerUnderTest(database, options).hits(rays);
  Counts counts;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ++counts.rays;
    const auto [verdict, is_hit] = rule.judge(rays[i], hits[i].is_miss() ? std::nullopt : std::optional(hits[i].t));
    if (is_hit) ++counts.hits;
    switch (verdict) {
      case Verdict::agrees: break;
      case Verdict::missed: ++counts.wrong[0]; break;
      case Verdict::invented: ++counts.wrong[1]; break;
      case Verdict::misplaced:
        ++counts.wrong[2];
        counts.worst = std::max(counts.worst, rule.excess(rays[i], hits[i].t));
        break;
      case Verdict::undecided: ++counts.undecided; break;
    }
  }
  return counts;
}

void print(const std::string& what, const Counts& c) {
  std::cout << what << ": " << c.rays << " rays, " << c.hits << " hits, missed " << c.wrong[0] << ", false "
            << c.wrong[1] << ", misplaced " << c.wrong[2] << " (up to " << c.worst << " times the allowed), undecided "
            << c.undecided << '\n';
}

render::TracerOptions options_of(const Certified& certified, double pixel_angle) {
  render::TracerOptions options;
  options.solver = certified.solver;
  options.packets = certified.packets;
  options.pixel_angle = pixel_angle;
  return options;
}

class EveryScale : public testing::TestWithParam<Certified> {};

TEST_P(EveryScale, KeepsEveryHitToEightUnits) {
  for (const Extreme extreme : {Extreme::far, Extreme::huge, Extreme::stretched}) {
    for (const int exponent : kExponents) {
      Counts total;
      std::uint64_t number = 0;
      std::map<std::string, Counts> bad;
      for (const Combination& combination : every_combination()) {
        RandomSource random(static_cast<std::uint64_t>(exponent) + 100 * number++);
        const ScaleCase made = scale_case(random, combination, extreme, exponent, kLines);
        const Counts counts =
            counts_of(made.database, camera_rays(made.lines), options_of(GetParam(), made.pixel_angle));
        total += counts;
        if (counts.all_wrong() > 0) bad[combination.name()] += counts;
      }
      const std::string where =
          std::string(kExtremeNames[static_cast<int>(extreme)]) + " 1e-" + std::to_string(exponent);
      print(where, total);
      for (const auto& [name, counts] : bad) print("  " + name, counts);
      EXPECT_GT(total.hits, total.rays / 4) << where << ": the rays must meet something";
      EXPECT_LE(total.undecided, total.rays / 1000) << where;
      EXPECT_EQ(total.all_wrong(), 0) << where;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Certified, EveryScale, testing::ValuesIn(kCertified),
                         [](const testing::TestParamInfo<Certified>& given) { return std::string(given.param.name); });

/// Where two hard fields all but cancel, each is many times the threshold, and so is its error: the constants of a
/// kernel must be right to rounding, and not only where it is worth 1.
TEST(HardKernels, AreRightFarWithinTheirSurfaceToo) {
  for (const double hardness : {60.0, 200.0, 300.0, 500.0}) {
    Counts total;
    std::uint64_t number = 0;
    for (const Combination& combination : combinations_of(every_kernel(hardness))) {
      RandomSource random(7000 + number++);
      Counts counts;
      for (int i = 0; i < 4; ++i) {
        const ScaleCase made = opposed_case(random, combination, kLines);
        counts += counts_of(made.database, camera_rays(made.lines), {});
      }
      total += counts;
      if (counts.all_wrong() > 0) print("  " + combination.name(), counts);
    }
    print(fmt::format("hardness {}", hardness), total);
    EXPECT_GT(total.hits, total.rays / 2);
    EXPECT_LE(total.undecided, total.rays / 1000);
    EXPECT_EQ(total.all_wrong(), 0);
  }
}

/// A grid of rays from <0, 0, −5> about the small ball at the origin.
std::vector<render::Ray> view_of_the_origin(double half_width, int side) {
  std::vector<render::Ray> rays;
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k) {
      const double x = half_width * ((2 * i + 1.0) / side - 1), y = half_width * ((2 * k + 1.0) / side - 1);
      rays.push_back(camera_ray({{0, 0, -5}, scene::Vec3(x, y, 5).normalized()}));
    }
  }
  return rays;
}

TEST(SmallBesideLarge, ABallKeepsItsAreaHoweverFarAnotherIs) {
  for (const double far : {1e4, 1e5, 1e6}) {
    for (const Certified& certified : kCertified) {
      const scene::Database database = one_blob(quartic(500), {point({0, 0, 0}, 1e-6), point({far, 0, 0}, 1)});
      const Counts counts =
          counts_of(database, view_of_the_origin(1.7e-6, 24), options_of(certified, 0.00004 * 3.14159 / 180 / 320));
      EXPECT_GT(counts.hits, 100);
      EXPECT_EQ(counts.all_wrong(), 0) << certified.name << ", the other at " << far;
    }
  }
}

TEST(SmallBesideLarge, AFlatBallIsHitOnItsSurface) {
  for (const double stretch : {1e3, 1e5, 1e6}) {
    for (const Certified& certified : kCertified) {
      scene::Database database = one_blob(gaussian(4), {point({0, 0, 0}, 1)});
      scene::Transform flat;
      flat.matrix.setScale(scene::Vec3(stretch, 1, 1 / stretch));
      flat.inverse.setScale(scene::Vec3(1 / stretch, 1, stretch));
      database.transforms.push_back(flat);
      database.blobs[0].components[0].transform = scene::TransformId{0};
      const Counts counts = counts_of(database, view_of_the_origin(0.9, 12), options_of(certified, 1e-3));
      EXPECT_GT(counts.hits, 100);
      EXPECT_EQ(counts.all_wrong(), 0) << certified.name << ", stretched by " << stretch;
    }
  }
}

}  // namespace
}  // namespace isl::reference
