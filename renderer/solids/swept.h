// The common part of prism and text: the points of space over the inside of an outline, between two heights. The
// section of a linear sweep is the same at every height; that of a conic one is scaled by the height, with the apex at
// the origin, so that a prism on both sides of it is a double one.
//
// A line is seen in the outline's plane from the apex, or along the axis: there it is a line too, and its crossings
// with the sides are those of the outline with that line (outline.h). Along the line they make intervals that are
// inside the endless sweep, and the solid is what the two heights cut from these. So every line that enters also
// leaves, for every rounding, and the caps need no test of their own.
#pragma once

#include "renderer/solids/capped.h"

namespace isl::render {

/// The coordinates that are u, v and the height of a sweep.
struct SweptAxes {
  int u, v, height;
};

[[nodiscard]] Crossings swept_crossings(SweptAxes axes, const scene::Solid& solid, const Vec3& origin,
                                        const Vec3& direction, std::uint32_t start_part,
                                        const SolidDetails& details) noexcept;
[[nodiscard]] Vec3 swept_normal(SweptAxes axes, const scene::Solid& solid, std::uint32_t part, const Vec3& point,
                                const SolidDetails& details) noexcept;
[[nodiscard]] Box swept_bounds(SweptAxes axes, const scene::Solid& solid, const SolidDetails& details) noexcept;
[[nodiscard]] double swept_support(SweptAxes axes, const scene::Database& database, const scene::Solid& solid,
                                   const Vec3& direction);
[[nodiscard]] bool is_in_swept(SweptAxes axes, const scene::Database& database, const scene::Solid& solid,
                               const Vec3& point);
[[nodiscard]] double swept_size(const scene::Database& database, const scene::Solid& solid);

/// The record of a kind whose sweep has these axes.
template <SweptAxes axes>
struct Swept {
  static Crossings crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                             std::uint32_t start_part, const SolidDetails& details) noexcept {
    return swept_crossings(axes, solid, origin, direction, start_part, details);
  }
  static Crossings boundary(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                            std::uint32_t start_part, const SolidDetails& details) noexcept {
    return capped_boundary(crossings, solid, origin, direction, start_part, details);
  }
  static constexpr SolidType type() {
    return {
        .crossings = crossings,
        .boundary = boundary,
        .normal = [](const scene::Solid& solid, std::uint32_t part, const Vec3& point,
                     const SolidDetails& details) noexcept { return swept_normal(axes, solid, part, point, details); },
        .bounds = [](const scene::Solid& solid,
                     const SolidDetails& details) noexcept { return swept_bounds(axes, solid, details); },
        .support = [](const scene::Database& database, const scene::Solid& solid,
                      const Vec3& direction) { return swept_support(axes, database, solid, direction); },
        .is_inside = [](const scene::Database& database, const scene::Solid& solid,
                        const Vec3& point) { return is_in_swept(axes, database, solid, point); },
        .size = swept_size};
  }
};

}  // namespace isl::render
