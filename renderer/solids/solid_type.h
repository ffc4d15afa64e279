// The functions of a kind of solid, in one record that the file of the kind defines. solid.cpp calls them by
// Solid::kind; all other code includes solid.h, which documents their contracts.
#pragma once

#include "renderer/solids/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace isl::render {

/// The surface of a solid that has only one, and the side of a cylinder or cone.
inline constexpr std::uint32_t kSide = 0;

/// Members without a default are required. The parameters are those of the functions in solid.h; `details` and
/// `database` are those of the scene with the solid, for the column that Solid::detail indexes.
struct SolidType {
  using CrossingsAlong = Crossings (*)(const scene::Solid&, const Vec3& origin, const Vec3& direction,
                                       std::uint32_t start_part, const SolidDetails& details) noexcept;
  using NormalAt = Vec3 (*)(const scene::Solid&, std::uint32_t part, const Vec3& point,
                            const SolidDetails& details) noexcept;

  CrossingsAlong crossings = nullptr;
  /// crossings_to_first(), for solids whose crossings take long to find.
  CrossingsAlong crossings_to_first = crossings;
  CrossingsAlong boundary = crossings;
  /// For solids with many crossings that take long to find; all others ignore the stretch.
  Crossings (*boundary_in_stretch)(const scene::Solid&, const Vec3& origin, const Vec3& direction,
                                   std::uint32_t start_part, const SolidDetails& details,
                                   const Stretch& stretch) noexcept = nullptr;
  bool (*is_open_surface)(const scene::Solid&) noexcept = [](const scene::Solid&) noexcept { return false; };
  NormalAt normal = nullptr;
  NormalAt shading_normal = normal;
  Box (*bounds)(const scene::Solid&, const SolidDetails& details) noexcept = nullptr;
  double (*support)(const scene::Database&, const scene::Solid&, const Vec3& direction) = nullptr;
  bool (*is_inside)(const scene::Database&, const scene::Solid&, const Vec3& point) = nullptr;
  double (*size)(const scene::Database&, const scene::Solid&) = size_of_members;
  double (*terms_over_gradient)(const scene::Solid&, const Vec3& point, const SolidDetails& details) noexcept =
      [](const scene::Solid&, const Vec3&, const SolidDetails&) noexcept { return 0.0; };
  Coordinates (*coordinates)(const scene::Solid&, const Vec3& point, const Vec3& world) noexcept =
      [](const scene::Solid&, const Vec3&, const Vec3& world) noexcept {
        return Coordinates{world.x, world.y};
      };
  bool is_part_of_plane = false;

  static double size_of_members(const scene::Database&, const scene::Solid& solid);
};

namespace kinds {
#define ISL_SOLID(word, ...) extern const SolidType word;
#include "renderer/scene/solids.def"
}  // namespace kinds

/// The crossings that a search wants.
enum class Wanted : std::uint8_t { all, first };

/// Adds crossings to a list until no more are wanted.
class CrossingsTaker {
 public:
  CrossingsTaker(Crossings& list, Wanted wanted) : list_(list), wanted_(wanted) {}

  /// False if this was the last one that is wanted.
  bool add(double t) {
    list_.add(t, kSide);
    is_done_ = wanted_ == Wanted::first && t > 0;
    return !is_done_;
  }
  [[nodiscard]] bool is_done() const { return is_done_; }

 private:
  Crossings& list_;
  Wanted wanted_;
  bool is_done_ = false;
};

/// For kinds that are always open surfaces.
[[nodiscard]] inline bool always_sheet(const scene::Solid&) noexcept { return true; }
[[nodiscard]] inline bool never_inside(const scene::Database&, const scene::Solid&, const Vec3&) { return false; }

/// The largest absolute coordinate.
[[nodiscard]] inline double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The power of two that scales `size` to about one: squares of coordinates then neither overflow nor underflow, and no
/// digit changes. It is finite and positive for every size but zero.
[[nodiscard]] inline double unit_of(double size) { return std::ldexp(1.0, std::clamp(-std::ilogb(size), -1000, 1000)); }

/// The support function of the unit disc perpendicular to the unit vector `axis`: the length of the component of
/// `direction` perpendicular to it.
[[nodiscard]] inline double reach_across(const Vec3& direction, const Vec3& axis) {
  return (direction - axis * direction.dot(axis)).length();
}

/// The greatest direction · p over the points.
[[nodiscard]] inline double farthest(std::span<const Vec3> points, const Vec3& direction) {
  double result = -std::numeric_limits<double>::infinity();
  for (const Vec3& point : points) result = std::max(result, direction.dot(point));
  return result;
}

}  // namespace isl::render
