// The triangle: above its face the distance from the plane, elsewhere that from the nearest edge. A triangle whose
// corners lie on a line, up to rounding, is its longest edge. q is convex, and so its slope is continuous where another
// edge becomes the nearest: a range holds those of all that may be it.
#include "renderer/reference/distances.h"

#include <algorithm>
#include <array>
#include <optional>

namespace isl::ISL_REFERENCE {
namespace {

class Triangle {
 public:
  Triangle(const std::array<Vector<Interval>, 3>& corners) {
    normal_ = cross(corners[1] - corners[0], corners[2] - corners[0]);
    normal2_ = squared_length(normal_);
    if (normal2_.lo() > 0) inverse2_ = Interval(1) / normal2_;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<Interval>&at = corners[i], &next = corners[(i + 1) % 3];
      at_[i] = at;
      inwards_[i] = cross(normal_, next - at);
      edges_[i] = Segment(at, next);
    }
    const auto shorter = [](const Segment& a, const Segment& b) {
      return a.squared_length_of().middle() < b.squared_length_of().middle();
    };
    longest_ = *std::ranges::max_element(edges_, shorter);
  }

  [[nodiscard]] Jet operator()(const Vector<Jet>& p) const {
    if (normal2_.lo() <= 0) return longest_(p);
    bool is_over = true, may_be_over = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Interval side = dot(from(at_[i], p), inwards_[i]).value;
      is_over = is_over && side.lo() >= 0;
      may_be_over = may_be_over && side.hi() >= 0;
    }
    const auto from_face = [&] { return square(dot(from(at_[0], p), normal_)) * inverse2_; };
    if (is_over) return from_face();
    std::array<Jet, 3> distances;
    for (std::size_t i = 0; i < 3; ++i) distances[i] = edges_[i](p);
    Real least = distances[0].value.hi();
    for (const Jet& one : distances) least = std::min(least, one.value.hi());
    std::optional<Jet> all;
    if (may_be_over) all = from_face();
    for (const Jet& one : distances) {
      if (one.value.lo() <= least) all = all ? hull(*all, one) : one;
    }
    return *all;
  }

 private:
  std::array<Vector<Interval>, 3> at_, inwards_;
  std::array<Segment, 3> edges_;
  Segment longest_;
  Vector<Interval> normal_;
  Interval normal2_, inverse2_;
};

}  // namespace

SquaredDistance triangle_distance(const scene::Component& c, const scene::Vec3& third_corner) {
  const Interval factor = Interval(1) / square(Interval(c.radius_a));
  return [=, triangle = Triangle({interval_of(c.a), interval_of(c.b), interval_of(third_corner)})](
             const Vector<Jet>& p) { return triangle(p) * factor; };
}

}  // namespace isl::ISL_REFERENCE
