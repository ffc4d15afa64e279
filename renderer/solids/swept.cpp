#include "renderer/solids/swept.h"

#include "renderer/solids/outline.h"
#include "renderer/solids/seen_line.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace isl::render {
namespace {

using scene::Outline;
using scene::Solid;

/// The crossings along a line with the sides of the endless sweep, t ascending, as far as they matter for what is seen
/// in the window. `start` is the place where the line starts if that is on a side, else null; its t is 0.
void find_side_crossings(const PreparedOutline& outline, const SeenLine& line, const LinearForm& form,
                         const PlaneWindow& window, const OutlinePlace* start, std::vector<OutlineCrossing>& found) {
  found.clear();
  find_crossings(outline, form, found, window, start);
  for (OutlineCrossing& crossing : found) crossing.t = crossing.is_start ? 0 : line.t_over(crossing.point);
  std::erase_if(found, [](const OutlineCrossing& crossing) { return !std::isfinite(crossing.t); });
  std::ranges::sort(found, {}, &OutlineCrossing::t);
}

// The part of a side names the curve that it stands on and tells whether the inside lies on the right of it, seen along
// the curve. So neither a normal nor a ray that starts there has to look for the two.
constexpr std::uint32_t kFirstSide = kCapB + 1;

std::uint32_t side_part(std::uint32_t node, bool is_inside_on_right) {
  return kFirstSide + 2 * node + (is_inside_on_right ? 1 : 0);
}
bool is_side(std::uint32_t part) { return part >= kFirstSide && part < kUnseen; }
std::uint32_t node_of(std::uint32_t side) { return (side - kFirstSide) / 2; }
bool is_inside_on_right(std::uint32_t side) { return (side - kFirstSide) % 2 == 1; }

/// The t between the two heights.
LineInterval between_heights(const Solid& solid, const SweptVector& origin, const SweptVector& direction,
                             std::uint32_t start_part) {
  double below_a = solid.radius_a - origin.height, below_b = solid.radius_b - origin.height;
  const double height = solid.radius_b - solid.radius_a;
  if (start_part == kCapA) below_a = 0, below_b = height;
  if (start_part == kCapB) below_a = -height, below_b = 0;
  const double rise = direction.height;
  LineInterval slab;
  if (rise != 0) {
    slab = LineInterval::between({below_a / rise, kCapA, start_part == kCapA},
                                 {below_b / rise, kCapB, start_part == kCapB});
  } else if (!(below_a < 0 && below_b > 0) && !is_side(start_part)) {
    slab = LineInterval::none();
  }
  if (is_side(start_part)) slab.hold_origin();
  return slab;
}

/// An end of an interval of the endless sweep; a known one is the start.
struct SideEnd {
  double t;
  bool is_known = false;
  std::uint32_t part = kNoPart;  ///< for a finite t
};

/// The contour passes from the right of the line to its left where `turn` is positive; then what is ahead on the line
/// is on the right of the contour.
SideEnd side_end(const OutlineCrossing& crossing, bool enters) {
  return {crossing.t, crossing.is_start, side_part(crossing.node, (crossing.turn > 0) == enters)};
}

/// Collects the intervals of a line inside the endless sweep, ascending, and adds their ends as far as they lie between
/// the heights. Intervals without length, and gaps without one, are none.
class InsideIntervals {
 public:
  InsideIntervals(const LineInterval& slab, bool is_open, Crossings& result)
      : slab_(slab), is_open_(is_open), result_(result) {}

  void add(const SideEnd& enter, const SideEnd& leave) {
    if (!(enter.t < leave.t)) return;
    if (is_pending_ && enter.t == leave_.t) {
      leave_ = leave;
      return;
    }
    finish();
    enter_ = enter;
    leave_ = leave;
    is_pending_ = true;
  }

  /// Called after the last interval.
  void finish() {
    if (!is_pending_) return;
    is_pending_ = false;
    if (!(enter_.t < slab_.high.t && leave_.t > slab_.low.t)) return;
    add_end(enter_, enter_.t > slab_.low.t, slab_.low);
    add_end(leave_, leave_.t < slab_.high.t, slab_.high);
  }

 private:
  void add_end(const SideEnd& side, bool is_at_side, const LineEnd& cap) {
    if (is_at_side) {
      if (!side.is_known) result_.add(side.t, side.part);
    } else if (!cap.known && !is_open_ && cap.part != kNoPart) {
      result_.add(cap.t, cap.part);
    }
  }

  const LineInterval& slab_;
  bool is_open_;
  Crossings& result_;
  bool is_pending_ = false;
  SideEnd enter_{}, leave_{};
};

/// For each line anew, so that only the longest list takes memory.
std::vector<OutlineCrossing>& scratch() {
  thread_local std::vector<OutlineCrossing> crossings;
  return crossings;
}

}  // namespace

Crossings swept_crossings(SweptAxes axes, const Solid& solid, const Vec3& origin, const Vec3& direction,
                          std::uint32_t start_part, const SolidDetails& details) noexcept {
  Crossings result;
  const PreparedOutline& outline = details.outlines[solid.detail];
  const SweptVector from(axes, origin), along(axes, direction);
  const LineInterval slab = between_heights(solid, from, along, start_part);
  if (slab.empty()) return result;
  const SeenLine line(outline.outline.is_conic, from, along);
  const LinearForm form = line.form();
  InsideIntervals inside(slab, solid.open, result);
  if (PlanePoint point; line.is_seen_as_point(form, point)) {
    if (!is_side(start_part) && contains(outline, point)) inside.add({-kInfinity}, {kInfinity});
    inside.finish();
    return result;
  }
  // The caller asks only for crossings in front of the start.
  const PlaneWindow window = line.window(std::max(slab.low.t, 0.0), slab.high.t);
  if (const auto side = outline.map.side_of(window.low, window.high); side != OutlineMap::Side::mixed) {
    if (side == OutlineMap::Side::inside) inside.add({-kInfinity}, {kInfinity});
    inside.finish();
    return result;
  }
  std::vector<OutlineCrossing>& found = scratch();
  const bool starts_on_side = is_side(start_part);
  OutlinePlace start;
  if (starts_on_side) start = nearest_on(outline, node_of(start_part), from.seen(outline.outline));
  find_side_crossings(outline, line, form, window, starts_on_side ? &start : nullptr, found);

  // The outline's inside is known where the line is certainly outside; before that, intervals are followed backwards,
  // which for a conic sweep is the same as counting all crossings before it.
  OutlineFill fill(outline.outline);
  const double outside = line.outside();
  for (const OutlineCrossing& crossing : found) {
    if (crossing.t < outside) fill.pass(crossing);
  }
  SideEnd enter{-kInfinity};
  for (const OutlineCrossing& crossing : found) {
    const bool was_inside = fill.is_inside();
    fill.pass(crossing);
    if (!was_inside && fill.is_inside()) enter = side_end(crossing, true);
    if (was_inside && !fill.is_inside()) inside.add(enter, side_end(crossing, false));
  }
  if (fill.is_inside()) inside.add(enter, {kInfinity});
  inside.finish();
  return result;
}

Vec3 swept_normal(SweptAxes axes, const Solid& solid, std::uint32_t part, const Vec3& point,
                  const SolidDetails& details) noexcept {
  if (!is_side(part)) return in_space(axes, {}, part == kCapA ? -1 : 1);
  const PreparedOutline& outline = details.outlines[solid.detail];
  const SweptVector place(axes, point);
  const bool is_conic = outline.outline.is_conic;
  const OutlinePlace foot = nearest_on(outline, node_of(part), place.seen(outline.outline));
  // To the right of the curve. Beyond the apex a conic sweep is turned round. Its sides hold the lines to the apex,
  // through (foot, 1), so that the normal is perpendicular to these too.
  const PlanePoint across{foot.tangent.v, -foot.tangent.u};
  const double outward = is_inside_on_right(part) != (is_conic && place.height < 0) ? -1 : 1;
  const double rise = is_conic ? -(across.u * foot.point.u + across.v * foot.point.v) : 0;
  const Vec3 normal = in_space(axes, {across.u, across.v}, rise) * outward;
  const double length = normal.length();
  return length > 0 ? normal / length : in_space(axes, {1, 0}, 0);
}

namespace {

/// The greatest value over the heights of a linear or conic sweep: `reach` is that over the outline, `rise` the
/// direction's height.
double farthest_of(const Outline& outline, const Solid& solid, const PlanePoint& direction, double rise) {
  if (!outline.is_conic) return reach_of(outline, direction) + std::max(solid.radius_a * rise, solid.radius_b * rise);
  const auto at = [&](double height) {
    const PlanePoint scaled{direction.u * height, direction.v * height};
    return reach_of(outline, scaled) + height * rise;
  };
  return std::max(at(solid.radius_a), at(solid.radius_b));
}

double reach_along(SweptAxes axes, const Outline& outline, const Solid& solid, const Vec3& direction) {
  const SweptVector seen(axes, direction);
  return farthest_of(outline, solid, seen.section, seen.height);
}

}  // namespace

Box swept_bounds(SweptAxes axes, const Solid& solid, const SolidDetails& details) noexcept {
  const Outline& outline = details.outlines[solid.detail].outline;
  Box box;
  for (int i = 0; i < 3; ++i) {
    Vec3 axis(0);
    axis[i] = 1;
    box.max[i] = reach_along(axes, outline, solid, axis);
    box.min[i] = -reach_along(axes, outline, solid, -axis);
  }
  return box;
}

double swept_support(SweptAxes axes, const scene::Database& database, const Solid& solid, const Vec3& direction) {
  return reach_along(axes, database.outlines[solid.detail], solid, direction);
}

bool is_in_swept(SweptAxes axes, const scene::Database& database, const Solid& solid, const Vec3& point) {
  const Outline& outline = database.outlines[solid.detail];
  const SweptVector place(axes, point);
  if (!(place.height >= solid.radius_a && place.height <= solid.radius_b)) return false;
  // The apex of a conic sweep is on the surface of all its sections and inside none.
  return !(outline.is_conic && place.height == 0) && contains(outline, place.seen(outline));
}

double swept_size(const scene::Database& database, const Solid& solid) {
  const Outline& outline = database.outlines[solid.detail];
  const double height = std::max(std::abs(solid.radius_a), std::abs(solid.radius_b));
  double size = 0;
  for (const PlanePoint& p : outline.points) size = std::max({size, std::abs(p.u), std::abs(p.v)});
  return std::max(height, outline.is_conic ? size * height : size);
}

}  // namespace isl::render
