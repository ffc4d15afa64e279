#include "renderer/reference/reference_skeleton.h"

#include "base/check.h"
#include "renderer/reference/distances.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

/// Along each axis the distance is that before the lower face or behind the upper one.
SquaredDistance box_distance(const scene::Component& c) {
  for (int i = 0; i < 3; ++i) ISL_CHECK(c.a[i] <= c.b[i], "a box from {} to {}", c.a[i], c.b[i]);
  const Interval factor = Interval(1) / square(Interval(c.radius_a));
  const Vector<Interval> low = interval_of(c.a), high = interval_of(c.b);
  return [=](const Vector<Jet>& p) {
    const Vector<Jet> above = from(high, p), below = from(low, p);
    return (positive_square(above.x) + positive_square(above.y) + positive_square(above.z) + positive_square(-below.x) +
            positive_square(-below.y) + positive_square(-below.z)) *
           factor;
  };
}

/// Half-space and sheet. The normal was normalised in double precision by the database, and is used as it is.
SquaredDistance plane_distance(const scene::Component& c) {
  const Interval factor = Interval(1) / square(Interval(c.radius_a));
  return [=, at = interval_of(c.a), normal = interval_of(c.b),
          has_two_sides = c.skeleton == scene::Skeleton::sheet](const Vector<Jet>& p) {
    const Jet x = dot(from(at, p), normal);
    return (has_two_sides ? square(x) : positive_square(x)) * factor;
  };
}

/// The middle of the smallest box that holds some points.
Vector<Real> middle_of(std::span<const scene::Vec3> points) {
  scene::Vec3 low = points[0], high = points[0];
  for (const scene::Vec3& point : points) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], point[i]);
      high[i] = std::max(high[i], point[i]);
    }
  }
  return (exactly(low) + exactly(high)) * Real(0.5L);
}

}  // namespace

ReferenceSkeleton::ReferenceSkeleton(const scene::Component& c, std::span<const scene::Vec3> corners)
    : centre_(exactly(c.a)), largest_radius_(c.radius_a) {
  ISL_CHECK(c.radius_a >= 0 && c.radius_b >= 0, "radii {} and {}", c.radius_a, c.radius_b);
  const auto spans = [this](std::initializer_list<scene::Vec3> points) {
    centre_ = middle_of(points);
    for (const scene::Vec3& point : points)
      half_size_ = std::max(half_size_, sqrt(squared_length(exactly(point) - centre_)) * kStretch);
  };
  switch (c.skeleton) {
    case scene::Skeleton::cone: largest_radius_ = std::max(c.radius_a, c.radius_b); [[fallthrough]];
    case scene::Skeleton::segment: spans({c.a, c.b}); [[fallthrough]];
    case scene::Skeleton::point: distance_ = limb_distance(c); break;
    case scene::Skeleton::box:
      spans({c.a, c.b});
      distance_ = box_distance(c);
      break;
    case scene::Skeleton::triangle:
      ISL_CHECK(c.corner < corners.size(), "corner {} of {}", c.corner, corners.size());
      spans({c.a, c.b, corners[c.corner]});
      distance_ = triangle_distance(c, corners[c.corner]);
      break;
    case scene::Skeleton::circle:
    case scene::Skeleton::disc:
      half_size_ = c.radius_b;
      distance_ = ring_distance(c);
      break;
    case scene::Skeleton::plane:
    case scene::Skeleton::sheet:
      half_size_ = kUnbounded;
      distance_ = plane_distance(c);
      plane_ = {interval_of(c.a), interval_of(c.b), c.skeleton == scene::Skeleton::sheet};
      break;
  }
}

std::optional<ReferenceSkeleton::Stretch> ReferenceSkeleton::change_on(const Line& line, Real root_q) const {
  if (!plane_) return std::nullopt;
  const Interval x = dot(line.origin - plane_->at, plane_->normal), speed = dot(line.direction, plane_->normal);
  if (speed.middle() == 0) return Stretch{0, 0};
  // If rounding hides whether the line comes nearer, its middle is taken: a stretch without end could not be searched.
  const Interval along = speed.sign() != 0 ? speed : Interval(speed.middle());
  const Real far = largest_radius_ * root_q;
  const Interval one = (Interval(plane_->has_two_sides ? -far : 0) - x) / along, other = (Interval(far) - x) / along;
  return Stretch{std::min(one.lo(), other.lo()), std::max(one.hi(), other.hi())};
}

}  // namespace isl::ISL_REFERENCE
