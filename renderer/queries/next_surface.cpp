#include "renderer/queries/next_surface.h"

#include "renderer/rays/ray_steps.h"
#include "renderer/trace/face.h"

#include <span>

namespace isl::render {
namespace {

constexpr double kStart = 4, kLeast = 16;

class Walk {
 public:
  Walk(const Tracer& tracer, const scene::Transform& parent_from_object, const Vec3& origin, const Vec3& direction)
      : tracer_(tracer), place_(parent_from_object), start_(origin), steps_(tracer.ray_steps()) {
    ray_.origin = origin;
    ray_.direction = direction;
  }

  NextSurface next() {
    while (true) {
      const Hit hit = hit_of(ray_);
      if (hit.is_miss() || steps_.is_spent()) return {ray_, hit, is_certain_ && !steps_.is_spent()};
      const Vec3 point = point_of(ray_, hit);
      const Face face = face_at(hit, point);
      const double size = face.rounding / kRounding;
      if (is_start(hit, point, face) || is_passed(hit, point, face)) {
        ray_ = beyond(ray_, hit);
      } else if (hit.t > 2 * size && taken_up_ < kMostTakingUp) {
        take_up_at(point - ray_.direction * size);
      } else if (const std::optional<NextSurface> back = way_back(hit, point, face)) {
        ray_ = beyond(back->ray, back->hit);
        passed_ = back->hit;
      } else {
        return {ray_, hit, is_certain_};
      }
    }
  }

 private:
  /// A ray is taken up again to make its coordinates about as small as those of the hit, which takes one turn, or two.
  /// A surface through the origin is approached by 2⁻⁵⁰ each time, until it is reached.
  static constexpr int kMostTakingUp = 32;
  /// Of the bound of a ray (rays/ray_steps.h), for tracing it once and placing its hit. Where no digits tell whether
  /// the ray has left a surface, it may be met again and again at the same place.
  static constexpr std::uint64_t kStepsOfTurn = 256;

  [[nodiscard]] Hit hit_of(const Ray& ray) {
    Hit hit;
    TraceCounters counters;
    tracer_.first_hits(std::span(&ray, 1), std::span(&hit, 1), counters, RayKind::query);
    static_cast<void>(steps_.take(kStepsOfTurn + counters.most_ray_steps));
    if (hit.certainty != Certainty::certified) is_certain_ = false;
    return hit;
  }
  [[nodiscard]] static Vec3 point_of(const Ray& ray, const Hit& hit) { return ray.origin + ray.direction * hit.t; }

  /// The ray that continues from a hit.
  [[nodiscard]] static Ray beyond(const Ray& ray, const Hit& hit) {
    Ray result = ray;
    result.origin = point_of(ray, hit);
    result.path_length += hit.t;
    result.start = hit.start();
    return result;
  }

  /// The reach of a point that is given by its coordinates around the object, as users see it.
  [[nodiscard]] Vec3 reach_of(const Vec3& point) const {
    return reach_through(place_.inverse, reach_at(Vec3(0), place_.point(point), 1));
  }
  /// The face of a hit, as exactly as it is known at that point.
  [[nodiscard]] Face face_at(const Hit& hit, const Vec3& point) const {
    return tracer_.face_at(hit, point, reach_of(point));
  }

  /// True if the surface met is the one that the walk starts on.
  [[nodiscard]] bool is_start(const Hit& hit, const Vec3& point, const Face& face) const {
    if (has_left_) return false;
    const double t = (point - start_).dot(ray_.direction);
    if (t * face.slope(ray_.direction) > kStart * face.rounding) return false;
    return t * face_at(hit, start_).slope(ray_.direction) <= kStart * face.rounding;
  }

  /// True if this is the crossing that the ray was just led beyond. Where it grazes a surface, rounding moves a
  /// crossing far along the ray, and it may come up again. It tells so itself: two crossings of a surface that follow
  /// each other go different ways.
  [[nodiscard]] bool is_passed(const Hit& hit, const Vec3& point, const Face& face) const {
    if (passed_.is_miss() || hit.instance != passed_.instance || hit.from_inside != passed_.from_inside) return false;
    return (point - ray_.origin).dot(ray_.direction) * face.slope(ray_.direction) <= kLeast * face.rounding;
  }

  /// Takes the ray up again at `origin`, so that its numbers are no larger than those that its next hit is made of.
  void take_up_at(const Vec3& origin) {
    const Vec3 direction = ray_.direction;
    ray_ = {};
    ray_.origin = origin;
    ray_.direction = direction;
    has_left_ = true;
    passed_ = {};
    ++taken_up_;
  }

  /// The crossing back through the surface, if the ray gets no farther from the surface in between than the least
  /// distance.
  [[nodiscard]] std::optional<NextSurface> way_back(const Hit& hit, const Vec3& point, const Face& face) {
    const double least = kLeast * face.rounding;
    NextSurface back{beyond(ray_, hit), {}};
    double left = least / kGrazing;
    while (left > 0 && !steps_.is_spent()) {
      back.ray.t_max = left;
      back.hit = hit_of(back.ray);
      if (back.hit.is_miss()) return std::nullopt;
      const Vec3 there = point_of(back.ray, back.hit);
      const double apart = (there - point).dot(ray_.direction);
      if (back.hit.instance == hit.instance && back.hit.from_inside != hit.from_inside) {
        const double slope = std::min(face.slope(ray_.direction), face_at(back.hit, there).slope(ray_.direction));
        if (apart * slope > least) return std::nullopt;
        back.ray.t_max = std::numeric_limits<double>::infinity();
        return back;
      }
      left -= back.hit.t;
      back.ray = beyond(back.ray, back.hit);
    }
    return std::nullopt;
  }

  const Tracer& tracer_;
  const scene::Transform& place_;
  Vec3 start_;
  Ray ray_;
  bool has_left_ = false;  ///< the start is too far behind to be met
  Hit passed_;             ///< the crossing at the ray's origin, if a way back through the surface ended there
  int taken_up_ = 0;
  RaySteps steps_;  ///< of the whole walk
  bool is_certain_ = true;
};

}  // namespace

NextSurface next_surface(const Tracer& tracer, const scene::Transform& parent_from_object, const Vec3& origin,
                         const Vec3& direction) {
  const Vec3 local = parent_from_object.inverse_vector(direction);
  const double length = local.length();
  if (!(length > 0)) return {};
  return Walk(tracer, parent_from_object, parent_from_object.inverse_point(origin), local / length).next();
}

}  // namespace isl::render
