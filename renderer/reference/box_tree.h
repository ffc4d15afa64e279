// Finds the few of many boxes that a line may meet, in double precision: more digits and proofs are for what is left. A
// box bounds the support of a component, or a placed blob. Used by reference_field and by the finder of first hits; it
// knows neither.
#pragma once

#include "renderer/reference/jet.h"
#include "renderer/scene/transform.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace isl::ISL_REFERENCE {

/// A box along the axes in double precision, which has been rounded outwards; empty if low > high.
struct Box {
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();

  std::array<double, 3> low{kInfinite, kInfinite, kInfinite}, high{-kInfinite, -kInfinite, -kInfinite};

  [[nodiscard]] static Box everything() {
    return {{-kInfinite, -kInfinite, -kInfinite}, {kInfinite, kInfinite, kInfinite}};
  }
  [[nodiscard]] bool is_empty() const { return !(low[0] <= high[0]); }
  [[nodiscard]] bool is_bounded() const;
  void take_in(const Box& other);
};

/// The box around a ball.
[[nodiscard]] Box box_around(const Vector<Real>& centre, Real radius);

/// Holds the points that `destination_from_source` takes into a ball. The map is inverted here, in extended precision,
/// and the inverse's error is part of the box: an inverse that is stored elsewhere may have lost its digits.
[[nodiscard]] Box box_before(const Vector<Real>& centre, Real radius, const scene::Matrix& destination_from_source);
/// The same for the ball around a box.
[[nodiscard]] Box box_before(const Box& box, const scene::Matrix& destination_from_source);

/// A half-line in double precision.
class RoughLine {
 public:
  explicit RoughLine(const Line& line);

  struct Stretch {
    double begin, end;  ///< begin > end if the half-line certainly passes the box
  };
  /// The t outside which the half-line is certainly outside the box.
  [[nodiscard]] Stretch within(const Box& box) const;
  [[nodiscard]] bool may_meet(const Box& box) const {
    const Stretch stretch = within(box);
    return !(stretch.begin > stretch.end);
  }

 private:
  struct Axis {
    double origin, origin_error;
    double inverse, share;  ///< of the direction; the share of itself by which the inverse may be off
    bool stands_still, tells_nothing;
  };
  std::array<Axis, 3> axes_;
};

/// A binary tree: each half of the boxes, sorted along the longest side, gets a box around it, and so on.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Holds all boxes.
  [[nodiscard]] const Box& bounds() const { return bounds_; }

  /// Appends the numbers of all boxes that the half-line may meet, in ascending order.
  void along(const RoughLine& line, std::vector<std::uint32_t>& numbers) const;

 private:
  static constexpr std::uint32_t kInner = 0xffffffff;
  struct Node {
    Box box;
    std::uint32_t after;   ///< the node to go on with, if the line passes the box
    std::uint32_t number;  ///< of a leaf's box, or kInner
  };
  /// Appends the nodes of these boxes, each before those of its halves.
  void build(std::span<std::uint32_t> numbers, const std::vector<Box>& boxes);

  std::vector<std::uint32_t> unbounded_;
  std::vector<Node> nodes_;
  Box bounds_;
};

}  // namespace isl::ISL_REFERENCE
