// Finds the few of many balls that a line may meet, in double precision: more digits and proofs are for what is left.
// A ball bounds the support of a component, or a placed blob. Used by reference_field and by the finder of first hits;
// it knows neither.
//
// The balls are sorted along a curve that fills space, every eight of them get a ball around them, every eight of those
// another, and so on: a tree without pointers, 37 bytes a ball.
//
// A ball is left out only if the line certainly passes it. Let w be the ball's centre as seen from the line's origin, d
// the direction, u = 2⁻⁵³. The distance |w × d|/|d| is off by
//   16u|w|            for the subtraction, the products, the sum and the roots,
//   e_o + e_d|w|/|d|  if origin and direction themselves are off by e_o and e_d.
// If squares overflow, infinities or NaN are compared, and the ball is kept.
#pragma once

#include "renderer/reference/interval.h"
#include "renderer/scene/transform.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isl::ISL_REFERENCE {

/// The half-line origin + t·direction, t in units of the direction's length, in the blob's space.
struct FieldRay {
  Vector<Interval> origin, direction;
};

/// A ball in double precision; it is everything if the radius is infinite.
struct Ball {
  double x = 0, y = 0, z = 0, radius = 0;
};

/// The ball about `centre`, rounded so that nothing gets lost.
[[nodiscard]] Ball rounded_ball(const Vector<Real>& centre, Real radius);

/// Holds the points that `destination_from_source` takes into a ball. The map is inverted here, in extended precision,
/// and the inverse's error is part of the ball: an inverse that is stored elsewhere may have lost its digits.
[[nodiscard]] Ball ball_before(const Vector<Real>& centre, Real radius, const scene::Matrix& destination_from_source);

/// A line in double precision.
struct RoughLine {
  explicit RoughLine(const FieldRay& ray);

  /// False if the line certainly passes the ball.
  [[nodiscard]] bool may_meet(const Ball& ball) const;
  /// No point of the ball is on the line before this t; 0 if the line begins in the ball or may do so.
  [[nodiscard]] double earliest(const Ball& ball) const;

  scene::Vec3 origin, direction;
  double length;                         ///< of the direction
  double origin_error, direction_error;  ///< bounds of their distances from the true ones
};

class BallTree {
 public:
  BallTree() = default;
  explicit BallTree(const std::vector<Ball>& balls);

  /// Holds all balls; its radius is −1 if there are none.
  [[nodiscard]] Ball bounds() const;

  /// Appends the numbers of all balls that the line may meet, in ascending order.
  void along(const RoughLine& line, std::vector<std::uint32_t>& numbers) const;

 private:
  void descend(std::size_t level, std::size_t place, const RoughLine& line, std::vector<std::uint32_t>& numbers) const;

  std::vector<std::uint32_t> unbounded_;
  std::vector<std::uint32_t> number_at_;   ///< the number of the ball at each place of the lowest level
  std::vector<std::vector<Ball>> levels_;  ///< the balls, then those around every eight of the level before
};

}  // namespace isl::ISL_REFERENCE
