// Tiles are halves that are mirrored at one of their sides: triangles of the golden ratio (Robinson). Each half parts
// into smaller halves of the same two forms, φ times smaller. A half with a corner in the origin contains again such a
// half in that corner. So arbitrarily large halves can be put there, and their parts agree where they overlap. To find
// the tile at a point, start with a half that is large enough, and follow the part that contains the point.
//
// By the symmetry of five mirrors points are first brought into the wedge of 36 degrees above the x axis. A half is
// turned over in each two steps; after four it lies as before, which is why their number is given modulo four.
#include "renderer/patterns/kinds/penrose.h"

#include <ImathVec.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

using Point = Imath::V2d;

constexpr double kGolden = std::numbers::phi;
constexpr double kCos36 = kGolden / 2;
const double kSin36 = std::sqrt(1 - kCos36 * kCos36);
const double kTan36 = kSin36 / kCos36;

double cross(const Point& a, const Point& b) noexcept { return a.x * b.y - a.y * b.x; }

/// A half: `is_wide` has 108 degrees in a and sides in the ratio 1 : 1 : φ, the other one 36 degrees and φ : φ : 1.
struct Half {
  bool is_wide;
  Point a, b, c;
};

Point toward(const Point& from, const Point& to) noexcept { return from + (to - from) / kGolden; }

/// True if p is on the same side of the line through `from` and `to` as `other`.
bool is_beside(const Point& p, const Point& from, const Point& to, const Point& other) noexcept {
  const Point along = to - from;
  return cross(along, p - from) * cross(along, other - from) >= 0;
}

double distance_from_line(const Point& p, const Point& from, const Point& to) noexcept {
  const Point along = to - from;
  return std::abs(cross(along, p - from)) / along.length();
}

/// The point's image between the x axis and the mirror at 36 degrees.
Point folded(Point p) noexcept {
  constexpr int kMostMirrors = 3;  // 180 degrees come to 108 and then to 36
  p.y = std::abs(p.y);
  for (int i = 0; i < kMostMirrors && p.y * kCos36 > p.x * kSin36; ++i) {
    const double along = p.x * kCos36 + p.y * kSin36, beyond = p.y * kCos36 - p.x * kSin36;
    p = {along * kCos36 + beyond * kSin36, std::abs(along * kSin36 - beyond * kCos36)};
  }
  return p;
}

/// The number of times that a half at the origin is parted, and its size before that.
struct Steps {
  int count;
  double scale;
};
/// At least `first` steps, and as many times four more as it takes for the scale to reach `distance`.
Steps steps_for(double distance, int first) noexcept {
  Steps steps{0, 1};
  for (; steps.count < first; ++steps.count) steps.scale *= kGolden;
  for (; steps.scale < distance; steps.count += 4) steps.scale *= kGolden * kGolden * kGolden * kGolden;
  return steps;
}

double value_of(int kind, int kinds, double inward) noexcept { return (kind + 1 - std::min(inward, 1.0)) / kinds; }

// ---- Rhombs: wide halves of wide rhombs are cut along the long diagonal bc, narrow ones along the short one
// ----------

Half part_of_rhomb(const Half& half, const Point& p) noexcept {
  const auto& [is_wide, a, b, c] = half;
  if (!is_wide) {
    const Point on_ab = toward(a, b);
    return is_beside(p, c, on_ab, b) ? Half{false, c, on_ab, b} : Half{true, on_ab, c, a};
  }
  const Point on_ba = toward(b, a), on_bc = toward(b, c);
  if (is_beside(p, on_bc, a, c)) return {true, on_bc, c, a};
  return is_beside(p, on_bc, on_ba, b) ? Half{true, on_ba, on_bc, b} : Half{false, on_bc, on_ba, a};
}

// ---- Kites (narrow halves: a the tail, b the nose) and darts (wide halves: a the hollow corner, b the tip)
// ------------

/// The part that holds the point. A kite has the parts 0 and 1, kites, and 2, a dart; a dart has 0, a kite, and 1, a
/// dart.
struct Part {
  Half half;
  int number;
};

Part part_of_kite(const Half& half, const Point& p) noexcept {
  const auto& [is_dart, a, b, c] = half;
  if (is_dart) {
    const Point on_bc = toward(b, c);
    if (is_beside(p, a, on_bc, b)) return {{false, b, a, on_bc}, 0};
    return {{true, on_bc, c, a}, 1};
  }
  const Point on_ab = toward(a, b), on_ca = toward(c, a);
  if (is_beside(p, c, on_ab, b)) return {{false, c, on_ab, b}, 0};
  if (is_beside(p, on_ab, on_ca, c)) return {{false, c, on_ab, on_ca}, 1};
  return {{true, on_ca, a, on_ab}, 2};
}

// ---- Pentagons, stars, boats and rhombs: their pieces lie in halves of kites and darts
// ----------------------------------

/// One step on the way to a half: whether what was parted was a dart, and the number of the part.
struct Step {
  bool is_dart = false;
  int part = 0;
};

/// A piece of a tile. Lengths are in short sides of kites, where pentagons have circles of radius ½ and 1/φ in and
/// around them.
struct Piece {
  int kind;
  double distance;  ///< from the tile's border
};
constexpr int kStar = 3, kBoat = 4, kRhomb = 5;

/// The distance of q beyond the side of the pentagon about `middle` that faces `sides` fifths of a turn from the x
/// axis; negative inside.
double beyond_side(const Point& q, const Point& middle, int sides) noexcept {
  const double cos72 = kGolden / 2 - 0.5, sin72 = 2 * kSin36 * kCos36;
  const Point outward = sides == 0 ? Point(1, 0) : sides == 1 ? Point(cos72, sin72) : Point(-kCos36, kSin36);
  return (q - middle).dot(outward) - 0.5;
}

/// A boat is a star with one straight edge in place of two points, a rhomb has two such edges. Their distance from q,
/// an offset from the middle of the tile, for an edge that faces `degrees` away from the axis of a point.
double inside_flat(const Point& q, double degrees) noexcept {
  const double angle = degrees * std::numbers::pi / 180;
  return kGolden - 1.5 - (q.x * std::cos(angle) + q.y * std::sin(angle));
}

/// q in the frame of the half: its tail in the origin, its nose along x, its side above.
Piece piece_of_kite(const Point& q, const Step& before, const Step& last) noexcept {
  const Point middle(1, 0);
  if (const double flat = beyond_side(q, middle, 0); flat > 0) return {last.is_dart ? kBoat : kRhomb, flat};
  if (const double point = beyond_side(q, middle, 2); point > 0) {
    // A point of a tile about the tail. Its axis is the kite's long side.
    if (last.is_dart || (!before.is_dart && before.part == 0)) return {kStar, point};
    const Point offset(q.x * kCos36 + q.y * kSin36, q.x * kSin36 - q.y * kCos36);
    return {kBoat, std::min(point, inside_flat(offset, last.part == 0 ? -108 : 180))};
  }
  const double corner = beyond_side(q, middle, 1);
  if (corner > 0) return {!last.is_dart && last.part == 0 ? 0 : 2, corner};
  return {1, -std::max({corner, beyond_side(q, middle, 0), beyond_side(q, middle, 2)})};
}

/// q in the frame of the half: its hollow corner in the origin, its tip along x, its wing above.
Piece piece_of_dart(const Point& q, const Step& last) noexcept {
  const Point middle(0, 0);
  const double tip = beyond_side(q, middle, 0), wing = beyond_side(q, middle, 1);
  if (wing > 0) {
    // A point of a tile about the wing. Its axis is the dart's long side, which is at 36 degrees to x.
    const Point c(0.5 - kGolden / 2, 2 * kSin36 * kCos36), v = q - c;
    const Point offset(v.x * kCos36 - v.y * kSin36, -v.x * kSin36 - v.y * kCos36);
    const double near_flat = std::min(wing, inside_flat(offset, 108));
    return last.is_dart ? Piece{kBoat, near_flat} : Piece{kRhomb, std::min(near_flat, inside_flat(offset, -108))};
  }
  if (tip > 0) return {0, tip};
  return {2, -std::max(tip, wing)};
}

/// p in the frame in which a is the origin, b lies along x, and c above.
Point in_frame(const Point& p, const Half& half) noexcept {
  const Point along = (half.b - half.a).normalized(), v = p - half.a;
  return {v.dot(along), std::copysign(1.0, cross(along, half.c - half.a)) * cross(along, v)};
}

/// 1 over the reach of borders: for pentagons and rhombs, and for kites.
constexpr double kPerDistance = 5.55 / kGolden, kKitePerDistance = 4.46;

Point at_36_degrees(double distance) noexcept { return {distance * kCos36, distance * kSin36}; }
/// The distance of a half's far side from the corner at the origin: of darts' tips, and of both others.
const double kTipCover = 2 * kSin36 * kCos36 / kGolden, kCover = 2 * kSin36 * kCos36;

}  // namespace

double penrose_pentagons(const scene::Vec3& point) noexcept {
  const Point p = folded({-point.x, point.z});
  const double unit = 1 / kTan36;  // the sides of pentagons are tan 36° of it
  const Steps steps = steps_for(p.length() / (kTipCover * kGolden * unit), 4);
  const double size = kGolden * unit * steps.scale;
  Half half{true, at_36_degrees(size / kGolden), {0, 0}, {size, 0}};
  Step before, last;
  for (int i = 0; i < steps.count; ++i) {
    const Part part = part_of_kite(half, p);
    before = last;
    last = {half.is_wide, part.number};
    half = part.half;
  }
  const Point q = in_frame(p, half) / unit;
  const Piece piece = half.is_wide ? piece_of_dart(q, last) : piece_of_kite(q, before, last);
  // POV-Ray lifts the middles of two kinds of pentagons by this, above an entry of a map at kind / kinds.
  const double least = piece.kind == 1 || piece.kind == 2 ? 6e-6 : 0;
  return value_of(piece.kind, 6, std::min(piece.distance * unit * kPerDistance, 1 - least));
}

double penrose_kites(const scene::Vec3& point) noexcept {
  const Point p = folded({point.x, point.z});
  const Steps steps = steps_for(p.length() / kCover, 2);
  Half half{false, {0, 0}, at_36_degrees(steps.scale), {steps.scale, 0}};
  for (int i = 0; i < steps.count; ++i) half = part_of_kite(half, p).half;
  const double from_long = half.is_wide ? distance_from_line(p, half.b, half.c) : distance_from_line(p, half.a, half.c);
  const double from_short =
      half.is_wide ? distance_from_line(p, half.a, half.c) : distance_from_line(p, half.b, half.c);
  return value_of(half.is_wide ? 1 : 0, 2, std::min(from_long, from_short) * kKitePerDistance);
}

double penrose_rhombs(const scene::Vec3& point) noexcept {
  const Point p = folded({point.x, point.z});
  const Steps steps = steps_for(p.length() / kCover, 0);
  Half half{true, {steps.scale, 0}, at_36_degrees(kGolden * steps.scale), {0, 0}};
  for (int i = 0; i < steps.count; ++i) half = part_of_rhomb(half, p);
  const double distance = std::min(distance_from_line(p, half.a, half.b), distance_from_line(p, half.a, half.c));
  return value_of(half.is_wide ? 0 : 1, 2, distance * kPerDistance);
}

}  // namespace isl::render
