// If e = Σ λⱼnⱼ with no λⱼ below 0, then e·x = Σ λⱼ(nⱼ·x) ≤ Σ λⱼdⱼ for all points x of the intersection. Three
// half-spaces are enough for the least such bound (duality of linear programs; Schrijver 1986, Theory of Linear and
// Integer Programming, §7), so all threes are tried for each side of the box. Every three that has such λ bounds
// the intersection, so none can make the box too small.
//
// What rounding leaves of e − Σ λⱼnⱼ, r, and what it changed in the normals, moves the bound by at most |r|₁ times the
// largest coordinate in the intersection, which is known once all six sides are.
#include "renderer/extents/bounding_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isl::render {
namespace {

using scene::Vec3;
using Box = Imath::Box3d;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostTried = 64;
/// Rounding of normals and distances, which come from a few products of matrices.
constexpr double kRounded = 0x1p-44;

double sum_of_sizes(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// The least bound of e·x that was found for one direction e of an axis.
struct Side {
  double bound = kUnbounded;
  double per_unit = 0;  ///< how much rounding may move it for each unit of the largest coordinate
};

/// Tries the bound by three half-spaces with the weights λ, as they were computed.
void try_bound(Side& side, const Vec3& e, const std::array<const BoundingPlane*, 3>& three, const Vec3& weights) {
  Vec3 rest = e;
  double bound = 0, total = 0;
  for (int i = 0; i < 3; ++i) {
    const BoundingPlane& h = *three[static_cast<std::size_t>(i)];
    const double weight = std::max(weights[i], 0.0);  // below 0 by rounding only
    rest -= h.normal * weight;
    bound += weight * (h.distance + kRounded * std::abs(h.distance));
    total += weight;
  }
  const double per_unit = sum_of_sizes(rest) + kRounded * total;
  // Three that are nearly in one plane have large weights, and bound little.
  if (!(per_unit < 0x1p-20) || !(bound < side.bound)) return;
  side = {bound, per_unit};
}

/// What half-spaces parallel to the axes say.
Box box_of_parallel(const std::vector<BoundingPlane>& planes) {
  Box box{Vec3(-kUnbounded), Vec3(kUnbounded)};
  for (const BoundingPlane& h : planes) {
    for (int axis = 0; axis < 3; ++axis) {
      if (h.normal[axis] == 1) box.max[axis] = std::min(box.max[axis], h.distance);
      if (h.normal[axis] == -1) box.min[axis] = std::max(box.min[axis], -h.distance);
    }
  }
  return box;
}

}  // namespace

BoundingPlane bounding_plane(const scene::Solid& plane, const scene::Transform& parent_from_object, bool is_turned) {
  const Vec3 normal = parent_from_object.normal(plane.a);
  const scene::Matrix& inverse = parent_from_object.inverse;
  const double distance = plane.radius_a - plane.a.dot(Vec3(inverse[3][0], inverse[3][1], inverse[3][2]));
  const double scale = (is_turned ? -1 : 1) / normal.length();
  return {normal * scale, distance * scale};
}

Imath::Box3d box_around(const std::vector<BoundingPlane>& planes) {
  const std::size_t count = std::min(planes.size(), kMostTried);
  std::array<Side, 6> sides;  // of x, −x, y, …
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 across = planes[i].normal.cross(planes[j].normal);
      for (std::size_t k = 0; k < j; ++k) {
        const std::array<const BoundingPlane*, 3> three{&planes[i], &planes[j], &planes[k]};
        const double volume = across.dot(three[2]->normal);
        if (volume == 0) continue;
        // Cramer's rule: the columns of the inverse of (nᵢ nⱼ nₖ) are λ for the axes.
        const Vec3 a = three[1]->normal.cross(three[2]->normal) / volume;
        const Vec3 b = three[2]->normal.cross(three[0]->normal) / volume, c = across / volume;
        for (int axis = 0; axis < 3; ++axis) {
          const Vec3 weights(a[axis], b[axis], c[axis]);
          const double least = -kRounded * sum_of_sizes(weights);
          Vec3 e(0);
          e[axis] = 1;
          const std::size_t side = 2 * static_cast<std::size_t>(axis);
          if (std::min({weights.x, weights.y, weights.z}) >= least) try_bound(sides[side], e, three, weights);
          if (-std::max({weights.x, weights.y, weights.z}) >= least) try_bound(sides[side + 1], -e, three, -weights);
        }
      }
    }
  }
  double largest = 0, per_unit = 0;
  for (const Side& side : sides) {
    largest = std::max(largest, std::abs(side.bound));
    per_unit = std::max(per_unit, side.per_unit);
  }
  if (!std::isfinite(largest)) return box_of_parallel(planes);
  largest /= 1 - per_unit;  // the largest coordinate is at most the largest bound and what rounding may add to it
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto outwards = [&](const Side& side) { return side.bound + side.per_unit * largest; };
    box.max[axis] = outwards(sides[2 * static_cast<std::size_t>(axis)]);
    box.min[axis] = -outwards(sides[2 * static_cast<std::size_t>(axis) + 1]);
    if (box.min[axis] > box.max[axis]) return {};
  }
  return box;
}

}  // namespace isl::render
