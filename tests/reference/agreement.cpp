// The rule by which a difference is judged. Let the results be t_a < t_b (a miss stands for the end of the thin feature
// that was missed). If |F| is within the rounding band everywhere between, the sign there is noise to a computation in
// double precision, and both results are right. The band is a sum, in units u = 2⁻⁵² and with four times the textbook's
// constants:
//   (n + 16)(Σ|fᵢ| + T)      a sum of n terms, each some 16 operations,
//   4·Σ|q·dfᵢ/dq|            relative errors of q, which hardness amplifies,
//   4·(|o| + |t|)·Σ|dfᵢ/dt|  relative errors of the ray's coordinates.
#include "tests/reference/agreement.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>

namespace isl::reference {
namespace {

constexpr long double kThinFraction = 1e-3L;

/// One ray of the comparison, seen by the reference.
struct Judged {
  const ReferenceScene& scene;
  const render::Ray& ray;
  RootOptions options;

  Judged(const ReferenceScene& all, const render::Ray& one) : scene(all), ray(one) {
    options.t_max = one.t_max;
    options.starts_on_root = one.start.instance != scene::kNone;
  }

  [[nodiscard]] FieldOnRay field(std::size_t placed) const {
    const ReferenceScene::Placed& blob = scene.placed()[placed];
    return {blob.field, ReferenceScene::field_ray(blob, ray.origin, ray.direction)};
  }

  [[nodiscard]] std::vector<Crossing> crossings(std::size_t placed) const {
    const ReferenceScene::Placed& blob = scene.placed()[placed];
    return roots_along(blob.field, ReferenceScene::field_ray(blob, ray.origin, ray.direction), options).crossings;
  }

  /// True if the answer is right for a start on the surface that only rounding has moved away from it.
  [[nodiscard]] bool is_right_from_rounded_start(bool occluded) const {
    if (!options.starts_on_root) return false;
    const ReferenceScene::Placed& blob = scene.placed().front();
    RootOptions rounded = options;
    rounded.start_band = rounding_band(field(0), exact_length(ray.origin), 0);
    const Line on_blob = ReferenceScene::field_ray(blob, ray.origin, ray.direction);
    return roots_along(blob.field, on_blob, rounded).crossings.empty() != occluded;
  }

  /// True if some blob's F is noise on all of [t0, t1].
  [[nodiscard]] bool is_noise(long double t0, long double t1) const {
    for (std::size_t i = 0; i < scene.placed().size(); ++i) {
      const FieldOnRay on_ray = field(i);
      const long double size = exact_length(ray.origin);
      const long double band = std::max({rounding_band(on_ray, size, t0), rounding_band(on_ray, size, (t0 + t1) / 2),
                                         rounding_band(on_ray, size, t1)});
      if (on_ray.stays_within({-band, band}, t0, t1)) return true;
    }
    return false;
  }

  /// The t at which the last support ends.
  [[nodiscard]] long double farthest() const {
    long double end = 0;
    for (std::size_t i = 0; i < scene.placed().size(); ++i) end = std::max(end, field(i).end());
    return end;
  }

  /// True if some blob's F comes within its rounding error of zero from below.
  [[nodiscard]] bool comes_within_noise() const {
    for (std::size_t i = 0; i < scene.placed().size(); ++i) {
      const FieldOnRay on_ray = field(i);
      const long double begin = std::max(on_ray.begin(), 0.0L), end = std::min(on_ray.end(), options.t_max);
      if (begin >= end) continue;
      const long double size = exact_length(ray.origin);
      const long double band =
          std::max({rounding_band(on_ray, size, begin), rounding_band(on_ray, size, (begin + end) / 2),
                    rounding_band(on_ray, size, end)});
      if (largest_value(on_ray, begin, end).hi() >= -band) return true;
    }
    return false;
  }

  [[nodiscard]] static long double exact_length(const scene::Vec3& v) { return std::sqrt(squared_length(exactly(v))); }

  /// The tolerance as a length at t.
  [[nodiscard]] long double tolerance_at(long double t, const AgreementOptions& all) const {
    return all.tolerance.in_pixels ? all.tolerance.value * footprint(t, all)
                                   : static_cast<long double>(all.tolerance.value);
  }
  [[nodiscard]] long double footprint(long double t, const AgreementOptions& all) const {
    return all.pixel_angle * (ray.path_length + t);
  }

  /// The t at which the feature ends that starts at `first`.
  [[nodiscard]] long double end_of_feature(std::size_t placed, const Crossing& first) const {
    for (const Crossing& crossing : crossings(placed)) {
      if (crossing.t > first.t) return crossing.t;
    }
    return std::min(options.t_max, field(placed).end());
  }

  /// The first root that remains when all features thinner than `thin` are left out, starting with the one at `first`.
  [[nodiscard]] std::optional<long double> beyond_thin(std::size_t placed, long double thin) const {
    const std::vector<Crossing> all = crossings(placed);
    std::size_t i = 0;
    while (i + 1 < all.size() && all[i + 1].t - all[i].t <= thin) i += 2;
    if (i < all.size()) return all[i].t;
    return std::nullopt;
  }
};

std::string place(const std::optional<long double>& t) {
  return t ? fmt::format("t = {:.17g}", static_cast<double>(*t)) : "a miss";
}

std::string path(const render::Ray& ray) {
  const scene::Vec3 &o = ray.origin, &d = ray.direction;
  return fmt::format("from <{:.17g}, {:.17g}, {:.17g}> along <{:.17g}, {:.17g}, {:.17g}>", o.x, o.y, o.z, d.x, d.y,
                     d.z);
}

/// Counts a ray that the tracer could not decide, of which it gives `answer`.
void add_flagged(Agreement& agreement, const render::Ray& ray, std::size_t number,
                 const std::optional<ReferenceScene::Hit>& truth, bool is_wrong, const std::string& answer,
                 const AgreementOptions& options) {
  ++agreement.flagged;
  if (is_wrong) ++agreement.wrong_flagged;
  if (agreement.listed_flagged.size() >= options.most_listed) return;
  const auto t = truth ? std::optional(truth->crossing.t) : std::nullopt;
  agreement.listed_flagged.push_back(fmt::format("flagged{}: ray {} {}: reference {}, tracer {}",
                                                 is_wrong ? ", wrong" : "", number, path(ray), place(t), answer));
}

/// Counts one ray's difference and describes it; [from, to] is the stretch on which the results contradict each other.
struct Difference {
  std::size_t Agreement::*kind;
  const char* name;
  std::optional<long double> reference_t, tracer_t;
  long double from, to;

  void add_to(Agreement& agreement, const Judged& judged, std::size_t number, const AgreementOptions& options) const {
    ++(agreement.*kind);
    if (agreement.listed.size() >= options.most_listed) return;
    long double highest = -std::numeric_limits<long double>::infinity();
    for (std::size_t i = 0; i < judged.scene.placed().size(); ++i) {
      highest = std::max(highest, largest_value(judged.field(i), from, to).lo());
    }
    agreement.listed.push_back(fmt::format("{}: ray {} {}: reference {}, tracer {}, sup F {:.3g}", name, number,
                                           path(judged.ray), place(reference_t), place(tracer_t),
                                           static_cast<double>(highest)));
  }
};

void judge_hit(Agreement& agreement, const Judged& judged, std::size_t number,
               const std::optional<ReferenceScene::Hit>& truth, const render::Hit& hit,
               const AgreementOptions& options) {
  if (truth) ++agreement.hits;
  if (!truth && hit.is_miss()) return;
  const std::optional<long double> tracer_t = hit.is_miss() ? std::nullopt : std::optional<long double>(hit.t);
  if (!truth) {
    if (judged.is_noise(hit.t, hit.t)) {
      ++agreement.lost_in_rounding;
    } else {
      const Difference invented{&Agreement::invented, "invented", std::nullopt, tracer_t, hit.t, hit.t};
      invented.add_to(agreement, judged, number, options);
    }
    return;
  }
  const long double t = truth->crossing.t, tolerance = judged.tolerance_at(t, options);
  const bool same_place = tracer_t && std::abs(*tracer_t - t) <= tolerance;
  const long double other = tracer_t ? *tracer_t : judged.end_of_feature(truth->placed, truth->crossing);
  const long double from = std::min(t, other), to = std::max(t, other);
  if (!same_place) {
    if (judged.is_noise(from, to)) {
      ++agreement.lost_in_rounding;
      return;
    }
    const std::optional<long double> beyond = judged.beyond_thin(truth->placed, tolerance * kThinFraction);
    const bool skips_thin_features = beyond != t && beyond.has_value() == tracer_t.has_value() &&
                                     (!beyond || std::abs(*beyond - *tracer_t) <= tolerance);
    if (skips_thin_features) {
      ++agreement.too_thin;
      return;
    }
    const Difference difference = tracer_t ? Difference{&Agreement::misplaced, "misplaced", t, tracer_t, from, to}
                                           : Difference{&Agreement::missed, "missed", t, tracer_t, from, to};
    difference.add_to(agreement, judged, number, options);
  } else if (hit.from_inside == truth->crossing.entering) {
    Difference{&Agreement::reversed, "reversed", t, tracer_t, from, to}.add_to(agreement, judged, number, options);
  }
  if (tracer_t) {
    agreement.worst_depth = std::max(agreement.worst_depth, to - from);
    agreement.worst_pixels = std::max(agreement.worst_pixels, (to - from) / judged.footprint(t, options));
  }
}

void judge_occlusion(Agreement& agreement, const Judged& judged, std::size_t number,
                     const std::optional<ReferenceScene::Hit>& truth, bool occluded, const AgreementOptions& options) {
  if (truth) ++agreement.hits;
  if (truth.has_value() == occluded) return;
  if (judged.is_right_from_rounded_start(occluded)) {
    ++agreement.lost_in_rounding;
    return;
  }
  if (!truth) {
    if (judged.comes_within_noise()) {
      ++agreement.lost_in_rounding;
    } else {
      // The results contradict each other on the whole ray.
      const long double end = std::isfinite(judged.ray.t_max) ? judged.options.t_max : judged.farthest();
      const Difference invented{&Agreement::invented, "invented shadow", std::nullopt, std::nullopt, 0, end};
      invented.add_to(agreement, judged, number, options);
    }
    return;
  }
  const long double t = truth->crossing.t, end = judged.end_of_feature(truth->placed, truth->crossing);
  if (judged.is_noise(t, end)) {
    ++agreement.lost_in_rounding;
  } else if (!judged.beyond_thin(truth->placed, judged.tolerance_at(t, options) * kThinFraction)) {
    ++agreement.too_thin;
  } else {
    Difference{&Agreement::missed, "missed shadow", t, std::nullopt, t, end}.add_to(agreement, judged, number, options);
  }
}

}  // namespace

long double rounding_band(const FieldOnRay& field, long double origin_size, long double t) {
  const FieldOnRay::Magnitude at = field.magnitude_at(t);
  const long double terms = static_cast<long double>(at.count) + 16;
  return 4 * 0x1p-52L *
         (terms * (at.values + std::abs(field.threshold())) + 4 * at.sensitivities +
          4 * (origin_size + std::abs(t)) * at.gradients);
}

std::string Agreement::text() const {
  std::string all = fmt::format(
      "{} rays, {} hits: missed {}, invented {}, misplaced {}, reversed {}; excused: rounding {}, thin {}; "
      "flagged {}, {} of them wrong; worst depth {:.3g}, {:.3g} px",
      rays, hits, missed, invented, misplaced, reversed, lost_in_rounding, too_thin, flagged, wrong_flagged,
      static_cast<double>(worst_depth), static_cast<double>(worst_pixels));
  for (const auto* lines : {&listed, &listed_flagged}) {
    for (const std::string& line : *lines) all += "\n  " + line;
  }
  return all;
}

Truth truth_of(const ReferenceScene& scene, std::span<const render::Ray> rays) {
  Truth truth;
  truth.reserve(rays.size());
  for (const render::Ray& ray : rays)
    truth.push_back(scene.first_hit(ray.origin, ray.direction, Judged(scene, ray).options));
  return truth;
}

Agreement compare_first_hits(const ReferenceScene& scene, const Truth& truth, const TraceBatch& trace,
                             std::span<const render::Ray> rays, const AgreementOptions& options) {
  ISL_CHECK(truth.size() == rays.size());
  std::vector<render::Hit> hits(rays.size());
  trace(rays, hits);
  Agreement agreement;
  agreement.rays = rays.size();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::size_t before = agreement.disagreements();
    judge_hit(agreement, Judged(scene, rays[i]), i, truth[i], hits[i], options);
    if (hits[i].certainty == render::Certainty::certified) continue;
    const auto found = hits[i].is_miss() ? std::nullopt : std::optional<long double>(hits[i].t);
    add_flagged(agreement, rays[i], i, truth[i], agreement.disagreements() > before, place(found), options);
  }
  return agreement;
}

Agreement compare_occlusions(const ReferenceScene& scene, const OccludeBatch& occlude,
                             std::span<const render::Ray> rays, const AgreementOptions& options) {
  for (const ReferenceScene::Placed& placed : scene.placed()) ISL_CHECK(!placed.no_shadow, "a shadowless blob");
  std::vector<std::uint8_t> occluded(rays.size());
  occlude(rays, occluded);
  const Truth truth = truth_of(scene, rays);
  Agreement agreement;
  agreement.rays = rays.size();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::size_t before = agreement.disagreements();
    judge_occlusion(agreement, Judged(scene, rays[i]), i, truth[i], occluded[i] == render::kOccluded, options);
    if (occluded[i] != render::kUndecidedOcclusion) continue;
    add_flagged(agreement, rays[i], i, truth[i], agreement.disagreements() > before, "an undecided shadow", options);
  }
  return agreement;
}

}  // namespace isl::reference
