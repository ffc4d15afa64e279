#include "renderer/accuracy/reference_check.h"

#include "base/parallel.h"
#include "renderer/compiled/compiled_scene.h"
#include "renderer/grid/field_classifier.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isl::render {
namespace {

enum class Verdict { proven, undecided, refuted, unchecked };

struct Judgement {
  Verdict verdict = Verdict::unchecked;
  double delta = 0;  ///< if proven: the root is certain to within delta
};

/// Most pieces of one ray in one blob before it counts as undecided: thousands of times more than a ray needs that does
/// not graze.
constexpr int kMostPieces = 1 << 14;

/// Part of a ray in a blob's own space.
struct Way {
  Vec3 origin, direction;
  double begin, end;
};

/// A point at t is computed, here and by any solver, from a transformed origin and direction. Its rounding, some eight
/// roundings of 2⁻⁵³ of numbers no larger than these, is within this bound.
double rounding_of(const Way& way) {
  const auto largest = [](const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
  return 0x1p-49 * (largest(way.origin) + std::abs(way.end) * largest(way.direction));
}

class BlobWay {
 public:
  BlobWay(const CompiledBlob& blob, const Way& way)
      : classifier_(blob.components, CellRule::ranges), way_(way), slack_(rounding_of(way)) {
    all_.resize(blob.components.size());
    std::iota(all_.begin(), all_.end(), 0u);
  }

  /// `empty` or `inside` if that is certain for all points with t0 ≤ t ≤ t1; else another kind.
  [[nodiscard]] CellKind kind(double t0, double t1) const { return kind(t0, t1, all_, kept_); }

  /// Tests that every point with t0 ≤ t ≤ t1 is of the kind `side`; `refuted` if some are certainly of the other kind.
  [[nodiscard]] Verdict stays(CellKind side, double t0, double t1) const {
    int pieces = 0;
    return stays(side, t0, t1, all_, pieces);
  }

 private:
  CellKind kind(double t0, double t1, std::span<const std::uint32_t> items, std::vector<std::uint32_t>& kept) const {
    Box box;
    for (const double t : {t0, t1}) box.extendBy(way_.origin + way_.direction * t);
    box.min -= Vec3(slack_);
    box.max += Vec3(slack_);
    return classifier_.classify(box, items, kept);
  }

  Verdict stays(CellKind side, double t0, double t1, std::span<const std::uint32_t> items, int& pieces) const {
    std::vector<std::uint32_t> kept;
    const CellKind found = kind(t0, t1, items, kept);
    if (found == side) return Verdict::proven;
    if (found == CellKind::empty || found == CellKind::inside) return Verdict::refuted;
    const double middle = t0 + 0.5 * (t1 - t0);
    if (++pieces > kMostPieces || !(middle > t0 && middle < t1)) return Verdict::undecided;
    const Verdict first = stays(side, t0, middle, kept, pieces);
    if (first == Verdict::refuted || pieces > kMostPieces) return first;
    const Verdict second = stays(side, middle, t1, kept, pieces);
    return second == Verdict::refuted ? second : first == Verdict::undecided ? first : second;
  }

  FieldClassifier classifier_;
  Way way_;
  double slack_;
  std::vector<std::uint32_t> all_;
  mutable std::vector<std::uint32_t> kept_;
};

class Checker {
 public:
  Checker(const CompiledScene& scene, double pixel_angle) : scene_(scene), pixel_angle_(pixel_angle) {}

  [[nodiscard]] Judgement judge(const Ray& ray, const Hit& hit) const {
    const bool on_blob = !hit.is_miss() && scene_.instances[hit.instance].kind == scene::Object::Kind::blob;
    if (!hit.is_miss() && !on_blob) return {};
    Judgement result;
    for (std::uint32_t i = 0; i < scene_.instances.size(); ++i) {
      const Instance& instance = scene_.instances[i];
      if (instance.kind == scene::Object::Kind::group) return {};  // its surface may or may not be a blob's
      if (instance.kind != scene::Object::Kind::blob) continue;
      const Judgement one = i == hit.instance ? judge_root(instance, ray, hit) : judge_clear(instance, ray, hit.t);
      if (one.verdict != Verdict::proven) return one;
      result = {Verdict::proven, std::max(result.delta, one.delta)};
    }
    return result;
  }

 private:
  static Way way_in(const Instance& instance, const Ray& ray, double end) {
    if (!instance.is_placed) return {ray.origin, ray.direction, 0, end};
    return {instance.world_from_object.inverse_point(ray.origin),
            instance.world_from_object.inverse_vector(ray.direction), 0, end};
  }

  [[nodiscard]] Judgement judge_root(const Instance& instance, const Ray& ray, const Hit& hit) const {
    const double pixel = pixel_angle_ * (ray.path_length + hit.t);
    const BlobWay way(scene_.blobs[instance.shape], way_in(instance, ray, hit.t + pixel));
    const bool begins_inside = hit.from_inside != instance.is_inverse;
    const CellKind before = begins_inside ? CellKind::inside : CellKind::empty;
    const CellKind after = begins_inside ? CellKind::empty : CellKind::inside;
    Judgement result{Verdict::undecided, 0};
    for (double delta = 0x1p-50 * hit.t; delta <= pixel; delta *= 8) {
      const double last = std::max(0.0, hit.t - delta);
      if (way.kind(last, last) != before || way.kind(hit.t + delta, hit.t + delta) != after) continue;
      result = {way.stays(before, 0, last), delta};
      if (result.verdict != Verdict::undecided) return result;
    }
    // The ray is on the other side already a pixel before the root, or there is no root near it: then it is not the
    // first.
    const double begin = std::max(0.0, hit.t - pixel);
    if (way.kind(begin, begin) == after || way.stays(before, begin, hit.t + pixel) == Verdict::proven) {
      return {Verdict::refuted, 0};
    }
    return result;
  }

  /// Tests that the blob has no surface before `end`.
  [[nodiscard]] Judgement judge_clear(const Instance& instance, const Ray& ray, double end) const {
    const CompiledBlob& blob = scene_.blobs[instance.shape];
    Way part = way_in(instance, ray, end);
    const Box bounds = blob.bounds();
    if (bounds.isEmpty()) return {Verdict::proven, 0};
    for (int axis = 0; axis < 3; ++axis) {  // outside its bounds there is no field at all
      if (part.direction[axis] == 0) {
        if (part.origin[axis] < bounds.min[axis] || part.origin[axis] > bounds.max[axis]) return {Verdict::proven, 0};
        continue;
      }
      const double one = (bounds.min[axis] - part.origin[axis]) / part.direction[axis];
      const double other = (bounds.max[axis] - part.origin[axis]) / part.direction[axis];
      // This covers a few roundings, each less than 2⁻⁵² of the values.
      part.begin = std::max(part.begin, std::min(one, other) * (1 - 0x1p-48));
      part.end = std::min(part.end, std::max(one, other) * (1 + 0x1p-48));
    }
    if (!(part.begin <= part.end)) return {Verdict::proven, 0};
    if (!std::isfinite(part.end)) return {};  // half-spaces have no end, so bisecting would not end
    const BlobWay way(blob, part);
    const CellKind side = way.kind(part.begin, part.begin);
    if (side != CellKind::empty && side != CellKind::inside) return {Verdict::undecided, 0};
    return {way.stays(side, part.begin, part.end), 0};
  }

  const CompiledScene& scene_;
  double pixel_angle_;
};

/// Keeps at most `most` of the numbers, evenly spread.
void thin(std::vector<std::size_t>& numbers, std::size_t most) {
  if (numbers.size() <= most) return;
  for (std::size_t i = 0; i < most; ++i) numbers[i] = numbers[i * numbers.size() / most];
  numbers.resize(most);
}

}  // namespace

ReferenceCheck check_reference(const scene::Database& database, const TracerOptions& options, const Tracer& tracer,
                               std::span<const Ray> rays, std::span<const RayMeasure> found, std::size_t sample) {
  const CompiledScene scene = compile(database, {.unblended = options.unblended});
  std::vector<std::size_t> chosen, misses;
  for (std::size_t i = 0; i < rays.size(); ++i) (found[i].is_miss() ? misses : chosen).push_back(i);
  thin(chosen, sample);
  thin(misses, sample);
  chosen.insert(chosen.end(), misses.begin(), misses.end());

  const Checker checker(scene, options.pixel_angle);
  std::vector<Judgement> judgements(chosen.size());
  parallel_for(judgements.size(), [&](std::size_t i) {
    const Ray& ray = rays[chosen[i]];
    Hit hit;
    TraceCounters counters;
    tracer.first_hits(std::span(&ray, 1), std::span(&hit, 1), counters);
    judgements[i] = checker.judge(ray, hit);
  });
  ReferenceCheck check;
  check.rays = judgements.size();
  for (std::size_t i = 0; i < judgements.size(); ++i) {
    switch (judgements[i].verdict) {
      case Verdict::proven: ++check.proven; break;
      case Verdict::undecided: ++check.undecided; break;
      case Verdict::refuted: ++check.refuted; break;
      case Verdict::unchecked: ++check.unchecked; break;
    }
    if (judgements[i].verdict == Verdict::proven && judgements[i].delta > 0) {
      const Ray& ray = rays[chosen[i]];
      const double pixel = options.pixel_angle * (ray.path_length + found[chosen[i]].t);
      check.worst_pixels = std::max(check.worst_pixels, judgements[i].delta / pixel);
    }
  }
  return check;
}

}  // namespace isl::render
