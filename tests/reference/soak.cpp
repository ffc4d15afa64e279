// The long proofs of the reference against the product, as long as you like. Every blob has a seed of its own, which is
// printed with every disagreement and with every ray that was not decided, so that it can be repeated. Exit code 1
// after a disagreement.
//
//   soak [FIRST_SEED [RAYS [STEPS]]]  (1, 1000000, the bound of a ray) as `soak blobs`
//   soak blobs FIRST_SEED RAYS      first hits and shadow rays of random blobs
//   soak scales FIRST_SEED RAYS     first hits of random blobs of several scales, every other of one scale
//   soak walks FIRST_SEED LINES     lines walked through random blobs by `trace`
//
// A blob has 1 to 200 components of all skeletons and kernels. Depending on the seed, half of them carve or are mapped,
// and it has maxima, sometimes a half-space (or a sheet), and every other time convolutions, a hardness up to 300, and
// a scale from 10⁻³ to 10³. Half of the rays of `blobs` look for the first hit, and half are shadow rays from the
// surfaces that were found, at all angles down to grazing.
#include "renderer/reference/reference_tracer.h"
#include "tests/reference/agreement.h"
#include "tests/reference/blob_walk.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/rounding_rule.h"
#include "tests/reference/scale_cases.h"
#include "tests/reference/small_scenes.h"
#include "tests/reference/soak_case.h"
#include "tests/reference/tracer_under_test.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace isl;
using namespace isl::reference;

struct Totals {
  std::uint64_t rays = 0, hits = 0, excused = 0, wrong = 0, undecided = 0, uncertified = 0;
  std::uint64_t bound = kStepsOfRay;        ///< of the steps of a ray
  std::uint64_t most_steps = 0, spent = 0;  ///< the greatest number that a ray took; rays whose bound ended them
  std::uint64_t flagged = 0;                ///< rays that the solver says it did not decide
  std::uint64_t wrong_flagged = 0;          ///< those of them that are wrong, which `wrong` does not count
  std::uint64_t needless = 0;               ///< those of them for which the reference sees no reason, in `scales` alone
  /// `scales`: rays and flagged rays by the exponent of the extent over the detail, 0 for blobs of one scale.
  std::map<int, std::pair<std::uint64_t, std::uint64_t>> by_exponent;
};

void judge(const Agreement& agreement, const char* what, std::uint64_t seed, Totals& totals) {
  totals.hits += agreement.hits;
  totals.excused += agreement.lost_in_rounding + agreement.too_thin;
  totals.wrong += agreement.disagreements() - agreement.wrong_flagged;
  totals.flagged += agreement.flagged;
  totals.wrong_flagged += agreement.wrong_flagged;
  if (agreement.disagreements() + agreement.flagged > 0)
    std::cout << "seed " << seed << ", " << what << ": " << agreement.text() << '\n';
}

void add_uncertified(const TracerUnderTest& tracer, std::uint64_t seed, Totals& totals) {
  const std::uint64_t steps = tracer.uncertified_steps();
  if (steps > 0) std::cout << "seed " << seed << ": " << steps << " uncertified steps\n";
  totals.uncertified += steps;
  totals.most_steps = std::max(totals.most_steps, tracer.most_ray_steps());
  totals.spent += tracer.spent_rays();
}

void soak_blob(std::uint64_t seed, Totals& totals) {
  RandomSource random(seed);
  const SoakCase made = soak_case(random);
  const ReferenceScene scene(made.database);
  render::TracerOptions options = with(render::SolverName::hermite, made.tolerance);
  options.run.steps_of_ray = totals.bound;
  const TracerUnderTest tracer(made.database, options);
  judge(compare_first_hits(scene, tracer.trace(), made.rays, tracer.comparison()), "first hits", seed, totals);

  const std::vector<render::Ray> shadows = shadow_rays(tracer, made.rays, made.scale, random);
  judge(compare_occlusions(scene, tracer.occlude(), shadows, tracer.comparison()), "shadows", seed, totals);
  add_uncertified(tracer, seed, totals);
  totals.rays += made.rays.size() + shadows.size();
}

/// True if the reference, too, sees something on the way to the hit that may be rounding: a place whose sign is lost in
/// extended precision, or a part so thin that the ray is out of it again before the hit.
bool has_reason(const ReferenceScene& scene, const render::Ray& ray, const render::Hit& hit) {
  constexpr long double kBeyond = 1 + 0x1p-40L;
  for (const ReferenceScene::Placed& placed : scene.placed()) {
    const RayRoots roots = roots_along(placed.field, ReferenceScene::field_ray(placed, ray.origin, ray.direction),
                                       {.t_max = std::min<long double>(hit.t, ray.t_max) * kBeyond});
    if (!roots.touches.empty() || roots.crossings.size() > 1) return true;
  }
  return false;
}

/// A line about a ray that was not decided: what the reference finds, and what the tracer does.
std::string listed_ray(const ReferenceScene& scene, const render::Ray& ray, const render::Hit& hit,
                       std::size_t number) {
  const auto place = [](bool is_miss, double t) {
    return is_miss ? std::string("a miss") : fmt::format("t = {:.17g}", t);
  };
  const auto truth = scene.first_hit(ray.origin, ray.direction, {.t_max = ray.t_max});
  return fmt::format(
      "\n  ray {} from <{:.17g}, {:.17g}, {:.17g}> along <{:.17g}, {:.17g}, {:.17g}>: reference {}, tracer {}", number,
      ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z,
      place(!truth, truth ? static_cast<double>(truth->crossing.t) : 0), place(hit.is_miss(), hit.t));
}

/// Counts by the rule of rounding, which allows no error in proportion to the blob.
void judge_hits(const scene::Database& database, const std::vector<LineOfSight>& lines, double pixel_angle,
                std::uint64_t seed, int exponent, const std::string& what, Totals& totals) {
  const RoundingRule rule(database);
  const ReferenceScene scene(database);
  auto& [rays_here, flagged_here] = totals.by_exponent[exponent];
  render::TracerOptions options;
  options.pixel_angle = pixel_angle;
  options.run.steps_of_ray = totals.bound;
  const TracerUnderTest tracer(database, options);
  const std::vector<render::Ray> rays = camera_rays(lines);
  const std::vector<render::Hit> hits = tracer.hits(rays);
  std::uint64_t wrong = 0, flagged = 0, needless = 0;
  long double worst = 0;  // |F| where a hit was found, over what the rule allows
  std::string listed;     // rays that were not decided
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ++totals.rays;
    ++rays_here;
    if (!hits[i].is_miss()) ++totals.hits;
    const bool is_flagged = hits[i].certainty != render::Certainty::certified;
    if (is_flagged) {
      ++flagged;
      if (!has_reason(scene, rays[i], hits[i])) ++needless;
      listed += listed_ray(scene, rays[i], hits[i], i);
    }
    switch (rule.judge(rays[i], hits[i].is_miss() ? std::nullopt : std::optional(hits[i].t)).verdict) {
      case Verdict::agrees: break;
      case Verdict::undecided: ++totals.undecided; break;
      default:
        if (is_flagged) {
          ++totals.wrong_flagged;
          break;
        }
        ++wrong;
        if (!hits[i].is_miss())
          worst = std::max(worst, rule.excess(rays[i], hits[i].t));
        else
          worst = std::numeric_limits<long double>::infinity();
        break;
    }
  }
  if (wrong > 0) {
    std::cout << fmt::format("seed {}: {} of {}, at most {:.3g} times the rule: {}\n", seed, wrong, rays.size(),
                             static_cast<double>(worst), what);
  }
  if (flagged > 0) {
    std::cout << fmt::format("seed {}: {} of {} flagged, {} without a reason: {}{}\n", seed, flagged, rays.size(),
                             needless, what, listed);
  }
  totals.wrong += wrong;
  totals.flagged += flagged;
  totals.needless += needless;
  flagged_here += flagged;
  add_uncertified(tracer, seed, totals);
}

void soak_scale(std::uint64_t seed, Totals& totals) {
  constexpr int kLines = 100;
  if (seed % 2 == 0) {
    RandomSource random(seed);
    const LinesThroughBlob made = lines_through_blob(random, kLines);
    judge_hits(made.database, made.lines, 1e-3, seed, 0, fmt::format("one scale, hardness {:.3g}", made.hardest),
               totals);
    return;
  }
  const auto [combination, extreme, exponent, made] = seeded_scale_case(seed, kLines);
  judge_hits(made.database, made.lines, made.pixel_angle, seed, exponent,
             fmt::format("{} 1e-{}, {}", kExtremeNames[static_cast<int>(extreme)], exponent, combination.name()),
             totals);
}

void soak_walk(std::uint64_t seed, WalkCounts& totals) {
  RandomSource random(seed);
  RandomBlobOptions options = varied_options(random);
  options.half_space = false;  // a bounded object
  options.components = 1 + options.components / 4;
  options.hardest = std::min(options.hardest, 60.0);
  const scene::Database database = random_blob(random, options);
  BlobWalk walk(database);
  for (const LineOfSight& line : random_lines(random, 100, 3 * options.scale, 0.7 * options.scale)) {
    WalkCounts one;
    if (!walk.walk(line, one)) {
      std::cout << fmt::format("seed {}: from <{}, {}, {}> along <{}, {}, {}>: {}\n", seed, line.origin.x,
                               line.origin.y, line.origin.z, line.direction.x, line.direction.y, line.direction.z,
                               one.text());
    }
    totals += one;
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::cout << std::unitbuf;  // what was found so far is seen while it goes on
  std::vector<std::string_view> words(argv + 1, argv + argc);
  std::string_view what = "blobs";
  if (!words.empty() && words.front().find_first_not_of("0123456789") != std::string_view::npos) {
    what = words.front();
    words.erase(words.begin());
  }
  const auto number = [&](std::size_t i, std::uint64_t otherwise) {
    return i < words.size() ? std::strtoull(words[i].data(), nullptr, 10) : otherwise;
  };
  const std::uint64_t first = number(0, 1), count = number(1, 1000000);
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  std::uint64_t seed = first;
  if (what == "walks") {
    WalkCounts totals;
    for (; totals.lines < count; ++seed) soak_walk(seed, totals);
    std::cout << fmt::format("seeds {} to {}: {}; {:.0f} s\n", first, seed - 1, totals.text(), seconds());
    return totals.wrong() > 0 ? 1 : 0;
  }
  if (what != "blobs" && what != "scales") {
    std::cerr << "soak: expected blobs, scales or walks, found " << what << '\n';
    return 2;
  }
  Totals totals;
  totals.bound = number(2, kStepsOfRay);
  for (; totals.rays < count; ++seed) what == "blobs" ? soak_blob(seed, totals) : soak_scale(seed, totals);
  const std::string needless = what == "scales" ? fmt::format(", {} without a reason", totals.needless) : "";
  std::cout << fmt::format(
      "seeds {} to {}: {} rays, {} hits, {} refuted, {} undecided by the reference, {} lost in rounding, {} "
      "uncertified steps, {} steps of a ray at most, {} rays at the bound, {} rays flagged as undecided, {} of them "
      "wrong{}; {:.0f} s\n",
      first, seed - 1, totals.rays, totals.hits, totals.wrong, totals.undecided, totals.excused, totals.uncertified,
      totals.most_steps, totals.spent, totals.flagged, totals.wrong_flagged, needless, seconds());
  for (const auto& [exponent, counts] : totals.by_exponent) {
    const std::string scale = exponent == 0 ? "one scale" : fmt::format("1e-{}", exponent);
    std::cout << fmt::format("  {}: {} flagged of {} rays\n", scale, counts.second, counts.first);
  }
  return totals.wrong > 0 ? 1 : 0;
}
