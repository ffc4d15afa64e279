// The published solver: its switches change the work and not the results, its error falls as the paper says, and `iso`
// has a smaller error for the same work.
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"
#include "tests/reference/tracer_under_test.h"
#include "tests/support/sphereflake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iostream>

namespace isl::reference {
namespace {

using render::PaperSwitches;

struct Published {
  render::SolverName name = render::SolverName::paper;
  int interpolants = 2;
  PaperSwitches switches;
};

render::TracerOptions options_of(const Published& solver) {
  render::TracerOptions options;
  options.solver = solver.name;
  options.interpolants = solver.interpolants;
  options.paper = solver.switches;
  return options;
}

constexpr Published kSolvers[] = {
    {render::SolverName::paper, 2, {}}, {render::SolverName::paper, 5, {}}, {render::SolverName::iso, 2, {}}};

PaperSwitches plain_but(bool PaperSwitches::*is_on) {
  PaperSwitches switches = render::kPlainPaper;
  switches.*is_on = true;
  return switches;
}

std::vector<render::Ray> random_rays(std::uint64_t seed, int count, double distance, double target) {
  RandomSource random(seed);
  std::vector<render::Ray> rays;
  for (int i = 0; i < count; ++i) rays.push_back(camera_ray(random_line(random, distance, target)));
  return rays;
}

/// Hits with their surfaces, shaded when they are found.
struct Seen {
  std::vector<render::Hit> hits;
  std::vector<render::SurfacePoint> points;
  render::TraceCounters counters;
};
Seen see(const scene::Database& database, const Published& solver, const std::vector<render::Ray>& rays) {
  const render::Tracer tracer(database, options_of(solver));
  Seen seen;
  seen.hits.resize(rays.size());
  seen.points.resize(rays.size());
  tracer.first_hits(rays, seen.hits, seen.counters);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!seen.hits[i].is_miss()) tracer.surface_at(rays[i], seen.hits[i], seen.points[i], seen.counters);
  }
  return seen;
}

bool is_same(const render::Hit& a, const render::Hit& b) {
  return std::bit_cast<std::uint64_t>(a.t) == std::bit_cast<std::uint64_t>(b.t) && a.from_inside == b.from_inside;
}

/// Blobs of all skeletons, kernels and branches; `positive`: only points with positive fields.
scene::Database blob_of(RandomSource& random, int components, bool positive) {
  RandomBlobOptions options{.components = components};
  options.maxima = random.below(2) == 0;
  if (!positive) {
    options.half_space = random.below(2) == 0;
    return random_blob(random, options);
  }
  options.negatives = false;
  scene::Database database = random_blob(random, options);
  for (scene::Component& component : database.blobs[0].components) component.skeleton = scene::Skeleton::point;
  return database;
}

constexpr bool PaperSwitches::*kOfTheSearch[] = {&PaperSwitches::on_demand, &PaperSwitches::monotone,
                                                 &PaperSwitches::reuse,     &PaperSwitches::permanent,
                                                 &PaperSwitches::pools,     &PaperSwitches::eq10};

TEST(PublishedSolver, NoSwitchButRejectChangesABitOfAnyHit) {
  RandomSource random(71);
  std::size_t hits = 0;
  for (const int components : {1, 3, 9, 30, 100}) {
    const scene::Database database = blob_of(random, components, false);
    const std::vector<render::Ray> rays = random_rays(72, 300, 3, 1);
    for (Published solver : kSolvers) {
      solver.switches = render::kPlainPaper;
      const Seen plain = see(database, solver, rays);
      for (const auto is_on : kOfTheSearch) {
        solver.switches = plain_but(is_on);
        const Seen seen = see(database, solver, rays);
        for (std::size_t i = 0; i < rays.size(); ++i) {
          hits += seen.hits[i].is_miss() ? 0 : 1;
          EXPECT_TRUE(is_same(plain.hits[i], seen.hits[i]))
              << components << " components, ray " << i << ": " << plain.hits[i].t << ' ' << seen.hits[i].t;
        }
      }
    }
  }
  EXPECT_GT(hits, 5000U);
}

TEST(PublishedSolver, RejectChangesNoHitWhereInterpolantsStayBelowTheirFieldsPeaks) {
  // The kernels are convex in the squared distance. So an interpolant of a point's field between two nodes on a ray
  // stays below the tangent from the nearer one, which stays below the peak.
  RandomSource random(73);
  for (const int components : {1, 3, 9, 30, 100}) {
    const scene::Database database = blob_of(random, components, true);
    const std::vector<render::Ray> rays = random_rays(74, 500, 3, 1);
    for (Published solver : kSolvers) {
      const Seen with = see(database, solver, rays);
      solver.switches.reject = false;
      const Seen without = see(database, solver, rays);
      for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_TRUE(is_same(with.hits[i], without.hits[i])) << i;
    }
  }
}

TEST(PublishedSolver, RejectTakesAwayOnlyWhatIsNotThere) {
  // In other cases an interpolant can exceed its field, and then rejection can lose a hit, which was a false one.
  RandomSource random(75);
  std::size_t rays_in_all = 0, differ = 0;
  for (const int components : {3, 9, 30, 100}) {
    const scene::Database database = blob_of(random, components, false);
    const ReferenceScene truth(database);
    const std::vector<render::Ray> rays = random_rays(76, 500, 3, 1);
    for (Published solver : kSolvers) {
      const Seen with = see(database, solver, rays);
      solver.switches.reject = false;
      const Seen without = see(database, solver, rays);
      rays_in_all += rays.size();
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if (is_same(with.hits[i], without.hits[i])) continue;
        ++differ;
        ASSERT_FALSE(without.hits[i].is_miss()) << components << " components, ray " << i;
        EXPECT_GT(with.hits[i].t, without.hits[i].t);
        const auto there = truth.first_hit(rays[i].origin, rays[i].direction);
        if (!there) continue;
        EXPECT_GT(static_cast<double>(there->crossing.t), without.hits[i].t);
      }
    }
  }
  std::cout << differ << " of " << rays_in_all << " rays differ\n";
  EXPECT_LT(differ, rays_in_all / 100);
}

TEST(PublishedSolver, ShadowsAreThoseOfItsFirstHits) {
  RandomSource random(77);
  const scene::Database database = blob_of(random, 30, false);
  const std::vector<render::Ray> rays = random_rays(78, 1000, 3, 1);
  for (const Published& solver : kSolvers) {
    const Seen seen = see(database, solver, rays);
    const TracerUnderTest tracer(database, options_of(solver));
    std::vector<std::uint8_t> occluded(rays.size());
    tracer.occlude()(rays, occluded);
    for (std::size_t i = 0; i < rays.size(); ++i)
      EXPECT_EQ(occluded[i] == render::kOccluded, !seen.hits[i].is_miss()) << i;
  }
}

TEST(PublishedSolver, ReuseLeavesTrueNormalsAsTheyAre) {
  RandomSource random(79);
  std::size_t compared = 0;
  for (const int components : {3, 9, 30, 100}) {
    // In a blob with maxima, the normal at a hit is that of the branch which is the greatest there.
    RandomBlobOptions options{.components = components};
    options.half_space = random.below(2) == 0;
    const scene::Database database = random_blob(random, options);
    const std::vector<render::Ray> rays = random_rays(80, 300, 3, 1);
    for (Published solver : kSolvers) {
      const Seen with = see(database, solver, rays);
      solver.switches.reuse = false;
      const Seen without = see(database, solver, rays);
      EXPECT_LE(with.counters.shading_evaluations, without.counters.shading_evaluations);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if (with.hits[i].is_miss()) continue;
        // The same terms are added in another order, which matters only where they cancel.
        EXPECT_GT(with.points[i].normal.dot(without.points[i].normal), 1 - 1e-9) << i;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 500U);
}

TEST(PublishedSolver, ReuseWeighsTexturesByTheInterpolants) {
  // Two textures on two overlapping balls; with many interpolants the shares are those of the fields.
  scene::Database database = one_blob(gaussian(2), {point({-0.6, 0, 0}, 1), point({0.7, 0.1, 0}, 0.8)});
  database.textures.resize(2);
  for (int i = 0; i < 2; ++i) database.blobs[0].components[static_cast<std::size_t>(i)].texture = scene::TextureId(i);
  const std::vector<render::Ray> rays = random_rays(81, 300, 4, 0.5);
  const auto worst = [&](int interpolants) {
    Published solver{render::SolverName::paper, interpolants, {}};
    const Seen with = see(database, solver, rays);
    solver.switches.reuse = false;
    const Seen without = see(database, solver, rays);
    double difference = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (with.hits[i].is_miss() || with.points[i].textures.size() != 2 || without.points[i].textures.size() != 2)
        continue;
      const auto weight_of_first = [](const render::SurfacePoint& point) {
        return point.textures[scene::index(point.textures[0].texture) == 0 ? 0 : 1].weight;
      };
      difference = std::max(difference, std::abs(weight_of_first(with.points[i]) - weight_of_first(without.points[i])));
    }
    return difference;
  };
  const double few = worst(2), many = worst(64);
  EXPECT_GT(few, 1e-2);
  EXPECT_GT(many, 0);
  EXPECT_LT(many, 1e-3 * few);
}

TEST(PublishedSolver, Equation10IsTheNormalOfAFieldAlone) {
  for (const scene::Kernel& kernel : {gaussian(4), quartic(3), cauchy(2)}) {
    const scene::Database database = one_blob(kernel, {cone({-0.5, 0, 0}, 0.6, {0.6, 0.2, 0}, 0.3)});
    const std::vector<render::Ray> rays = random_rays(82, 300, 3, 0.5);
    for (const bool reuse : {true, false}) {
      Published solver;
      solver.switches.reuse = reuse;
      const Seen truth = see(database, solver, rays);
      solver.switches.eq10 = true;
      const Seen seen = see(database, solver, rays);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if (seen.hits[i].is_miss()) continue;
        EXPECT_GT(seen.points[i].normal.dot(truth.points[i].normal), 1 - 1e-12) << i;
      }
    }
  }
}

TEST(PublishedSolver, Equation10IsOffByTensOfDegreesAtJoints) {
  // A thin branch on a thick trunk: where the fields are equal, their slopes are in the inverse ratio of their radii.
  const scene::Database database = one_blob(gaussian(4), {point({0, 0, 0}, 1), segment({0.9, 0, 0}, {2, 0, 0}, 0.15)});
  const std::vector<render::Ray> rays = random_rays(83, 4000, 4, 1.2);
  Published solver{render::SolverName::paper, 32, {}};
  const Seen truth = see(database, solver, rays);
  solver.switches.eq10 = true;
  const Seen seen = see(database, solver, rays);
  double least = 1;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_TRUE(is_same(truth.hits[i], seen.hits[i]));
    if (!seen.hits[i].is_miss()) least = std::min(least, seen.points[i].normal.dot(truth.points[i].normal));
  }
  const double degrees = std::acos(least) * 180 / std::acos(-1.0);
  std::cout << "equation 10 is off by up to " << degrees << " degrees\n";
  EXPECT_GT(degrees, 10);
}

TEST(PublishedSolver, EachSwitchSavesItsOwnEvaluations) {
  const scene::Database database = test::sphereflake(3, gaussian(4));
  const std::vector<render::Ray> rays = random_rays(84, 3000, 3, 0.9);
  const auto counted = [&](const PaperSwitches& switches, int interpolants = 4) {
    return see(database, {render::SolverName::paper, interpolants, switches}, rays).counters;
  };
  const auto plain = counted(render::kPlainPaper), on_demand = counted(plain_but(&PaperSwitches::on_demand)),
             reject = counted(plain_but(&PaperSwitches::reject)), reuse = counted(plain_but(&PaperSwitches::reuse)),
             permanent = counted(plain_but(&PaperSwitches::permanent)), all = counted({});
  EXPECT_LT(on_demand.field_evaluations, plain.field_evaluations * 3 / 4);
  EXPECT_LT(permanent.field_evaluations, plain.field_evaluations * 3 / 4);
  EXPECT_LT(permanent.cells, plain.cells);
  EXPECT_LT(all.field_evaluations, on_demand.field_evaluations);
  EXPECT_LT(reuse.shading_evaluations, plain.shading_evaluations * 3 / 4);
  EXPECT_EQ(reuse.field_evaluations, plain.field_evaluations);
  EXPECT_LT(reject.field_evaluations, plain.field_evaluations);
  PaperSwitches equation_10;
  equation_10.eq10 = true;
  EXPECT_EQ(counted(equation_10).shading_evaluations, 0U);
}

/// The distances, ascending, between a solver's hits and the certified solver's, along the rays that both hit.
std::vector<double> errors(const scene::Database& database, const Published& solver,
                           const std::vector<render::Ray>& rays) {
  const TracerUnderTest exact(database, with(render::SolverName::exact, {1e-12, false}));
  const std::vector<render::Hit> truth = exact.hits(rays);
  const Seen seen = see(database, solver, rays);
  std::vector<double> found;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!truth[i].is_miss() && !seen.hits[i].is_miss()) found.push_back(std::abs(truth[i].t - seen.hits[i].t));
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(PublishedSolver, ErrorFallsSixteenfoldWhenInterpolantsDouble) {
  // The paper's cross. The windowed Gaussian is smooth except at its border, so the order is four only in the limit.
  const scene::Database database = one_blob(
      gaussian(4), {segment({-1.2, -1.2, 0}, {1.2, 1.2, 0}, 0.3), segment({-1.2, 1.2, 0}, {1.2, -1.2, 0}, 0.3)});
  const std::vector<render::Ray> rays = random_rays(85, 2000, 7, 1.2);
  std::vector<double> medians;
  for (int k = 2; k <= 128; k *= 2) {
    const std::vector<double> found = errors(database, {render::SolverName::paper, k, {}}, rays);
    ASSERT_GT(found.size(), 300U);
    medians.push_back(found[found.size() / 2]);
    std::cout << "K = " << k << ": median error " << medians.back() << '\n';
    if (k > 2) {
      EXPECT_LT(medians.back(), medians[medians.size() - 2] / 2) << k;
    }
  }
  // The order over the last three doublings, from 16 to 128.
  const double order = std::log2(medians[medians.size() - 4] / medians.back()) / 3;
  std::cout << "order " << order << '\n';
  EXPECT_NEAR(order, 4, 0.25);
}

TEST(PublishedSolver, IsoNodesCostNothingAndAreMoreAccurate) {
  const scene::Database database = test::sphereflake(4, gaussian(4));
  const std::vector<render::Ray> rays = random_rays(86, 3000, 3, 0.9);
  const Published iso{render::SolverName::iso, 2, {}};
  const std::vector<double> of_paper = errors(database, {}, rays), of_iso = errors(database, iso, rays);
  const auto quantile = [](const std::vector<double>& v, double share) {
    return v[static_cast<std::size_t>(share * static_cast<double>(v.size() - 1))];
  };
  std::cout << "median, 95 %: paper:2 " << quantile(of_paper, 0.5) << ' ' << quantile(of_paper, 0.95) << ", iso "
            << quantile(of_iso, 0.5) << ' ' << quantile(of_iso, 0.95) << '\n';
  EXPECT_LT(quantile(of_iso, 0.5), 1e-3 * quantile(of_paper, 0.5));
  EXPECT_LT(quantile(of_iso, 0.95), 0.05 * quantile(of_paper, 0.95));
  const Seen with_paper = see(database, {}, rays), with_iso = see(database, iso, rays);
  EXPECT_LT(static_cast<double>(with_iso.counters.field_evaluations),
            1.2 * static_cast<double>(with_paper.counters.field_evaluations));
}

TEST(PublishedSolver, IsoIsExactWhereAFieldIsAlone) {
  for (const scene::Kernel& kernel : {gaussian(4), quartic(3), soft(2), metaball(2), cauchy(3), kPovRay}) {
    scene::Database database = one_blob(kernel, {cone({-0.5, 0, 0}, 0.6, {0.6, 0.2, 0}, 0.3, 2.0)});
    database.blobs[0].threshold = 0.7;
    const std::vector<double> found = errors(database, {render::SolverName::iso, 2, {}}, random_rays(87, 500, 3, 0.4));
    ASSERT_GT(found.size(), 200U);
    EXPECT_LT(found.back(), 1e-6);
    EXPECT_LT(found[found.size() / 2], 1e-13);
  }
}

}  // namespace
}  // namespace isl::reference
