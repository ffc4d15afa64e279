// Tilings of the plane of x and z by polyforms: the value is 1 on their borders and falls to 0 at the middle of a row
// of cells. polyforms.def lists the edges that are borders.
//
// Every cell, a regular polygon of side 1, is parted into kites, one for each corner: between the corner, the middle of
// the cell, and the middles of the two edges that meet there. The value in a kite follows from whether these edges, and
// those beyond the corner, are borders.
//
// The value is 1 − d / R of the distance d from the border, where R is how far borders reach, but for corners:
// `exterior` shapes those of a polyform's ends, `form` those at which it turns, `interior` the hollow ones. 0 is sharp,
// 1 is a chamfer, 2 is round. All formulas were found by asking POV-Ray 3.7 for the values around each sort of corner,
// and agree with it at random points of all polyforms.
#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/patterns/kinds/polyforms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>

namespace isl::render {
namespace {

constexpr double kTriangleHeight = std::numbers::sqrt3 / 2;  ///< of a triangle of side 1
constexpr double kInradius =
    kTriangleHeight / 3;  ///< R of triangles, the radius of their inscribed circle, and of hexagons

struct Pavement {
  int sides = 3;
  int tiles = 1;
  int pattern = 1;
  int form = 0;
  int interior = 0;
  int exterior = 0;
};

double fading(double distance, double reach) { return std::clamp(1 - distance / reach, 0.0, 1.0); }

// ---- Squares --------------------------------------------------------------------------------------------------------

/// Edges and corners of a square in turn: right, upper, left, lower; corner k lies between the edges k and k + 1.
class Square {
 public:
  Square(const PolyformBorders& borders, double i, double j) noexcept
      : borders_(borders), i_(i), j_(j), edges_{right(0, 0), upper(0, 0), right(-1, 0), upper(0, -1)} {}

  [[nodiscard]] bool edge(std::size_t k) const { return edges_[k % 4]; }
  /// Neither edge at the corner is a border, but one beyond it is.
  [[nodiscard]] bool is_hollow(std::size_t k) const {
    if (edge(k) || edge(k + 1)) return false;
    switch (k % 4) {
      case 0: return right(0, 1) || upper(1, 0);
      case 1: return upper(-1, 0) || right(-1, 1);
      case 2: return right(-1, -1) || upper(-1, -1);
      default: return upper(1, -1) || right(0, -1);
    }
  }

 private:
  [[nodiscard]] bool right(double x, double z) const { return borders_(i_ + x, j_ + z, 0); }
  [[nodiscard]] bool upper(double x, double z) const { return borders_(i_ + x, j_ + z, 1); }

  const PolyformBorders& borders_;
  double i_, j_;
  std::array<bool, 4> edges_;
};

/// The corner that is cut from the square at the other end of the diagonal from a hollow one: a polyform turns there; 4
/// for none.
std::size_t turning_corner(const Square& square) noexcept {
  for (std::size_t k = 0; k < 4; ++k) {
    if (square.edge(k) && square.edge(k + 1) && square.is_hollow(k + 2)) return k;
  }
  return 4;
}

/// The length of an offset in the plane: by the circle, or as the sum of both terms, which makes a chamfer.
double length_of(double x, double z, bool is_round) { return is_round ? std::hypot(x, z) : x + z; }

double squares(const Pavement& o, const PolyformBorders& borders, const Vec3& p) noexcept {
  const double i = std::floor(p.x), j = std::floor(p.z), x = p.x - i, z = p.z - j;
  const Square square(borders, i, j);
  const double distances[] = {1 - x, 1 - z, x, z};
  const std::size_t k = x >= 0.5 ? (z >= 0.5 ? 0 : 3) : (z >= 0.5 ? 1 : 2), next = (k + 1) % 4;
  const double u = distances[k], v = distances[next];
  const std::size_t turn = turning_corner(square);
  if (turn < 4 && (o.form == 1 || o.form == 2)) {
    // Between the hollow corner and the arc around it.
    const double r = length_of(1 - distances[turn], 1 - distances[(turn + 1) % 4], o.form == 2);
    return std::min(std::abs(2 * r - 1), 1.0);
  }
  const bool follows_form = turn < 4 && o.form == 0;  // a form of 3 leaves both corners to the other two
  if (square.edge(k) && square.edge(next)) {
    if (o.exterior == 0 || follows_form) return 1 - 2 * std::min(u, v);
    return std::min(length_of(1 - 2 * u, 1 - 2 * v, o.exterior == 2), 1.0);
  }
  if (square.edge(k)) return 1 - 2 * u;
  if (square.edge(next)) return 1 - 2 * v;
  if (!square.is_hollow(k)) return 0;
  if (o.interior == 0 || follows_form) return 1 - 2 * std::max(u, v);
  return fading(length_of(u, v, o.interior == 2), 0.5);
}

// ---- Corners of 60 and 120 degrees ----------------------------------------------------------------------------------

/// A point in the frame of a corner: along one edge, and away from it towards the cell.
struct CornerPoint {
  double along, away;
};
/// The same about the other edge, which is at 60 degrees from the first.
CornerPoint about_other_edge(const CornerPoint& p) noexcept {
  return {0.5 * p.along + kTriangleHeight * p.away, kTriangleHeight * p.along - 0.5 * p.away};
}

/// The value near a corner of 120 degrees between two borders; `p` is in the frame of the nearer one. The chamfer joins
/// the middles of the two borders; the arc is part of the circle that touches both there.
double turned(int form, const CornerPoint& p) noexcept {
  if (form == 1) return std::clamp(2 - 4 * (0.5 * p.along + kTriangleHeight * p.away), 0.0, 1.0);
  if (form == 2)
    return std::clamp(1 - (kTriangleHeight - std::hypot(p.along - 0.5, p.away - kTriangleHeight)) / kInradius, 0.0,
                      1.0);
  return fading(p.away, kInradius);
}

/// The value in a sector of 60 degrees at a hollow corner, neither of whose edges is a border. Along both edges the
/// value falls to 0 at 1/3, where the borders beside them reach too.
double hollow(int interior, const CornerPoint& p) noexcept {
  constexpr double kHollowReach = 1.0 / 3;
  const double along_other = about_other_edge(p).along;
  if (interior == 1) return fading(std::max(p.along, along_other), kHollowReach);
  if (interior == 2) return fading(std::hypot(p.along, p.away), kHollowReach);
  return fading((p.along + along_other) / std::numbers::sqrt3, kHollowReach * kTriangleHeight);
}

// ---- Triangles ------------------------------------------------------------------------------------------------------

/// The six edges that meet at a corner of the lattice, in steps of 60 degrees from the one along x.
std::array<bool, 6> edges_around(const PolyformBorders& borders, double i, double j) noexcept {
  return {borders(i, j, 0),     borders(i, j, 2),     borders(i - 1, j, 1),
          borders(i - 1, j, 0), borders(i, j - 1, 2), borders(i, j - 1, 1)};
}

double end_of_triangle(int exterior, const CornerPoint& p) noexcept {
  const double sharp = fading(std::min(p.away, about_other_edge(p).away), kInradius);
  // The point relative to the middle of the triangle.
  const double x = 0.5 - p.along, z = kInradius - p.away;
  if (exterior == 1) return std::min(std::max(sharp, (kTriangleHeight * x + 0.5 * z) / kInradius), 1.0);
  if (exterior == 2) return std::min(std::hypot(x, z) / kInradius, 1.0);
  return sharp;
}

double triangles(const Pavement& o, const PolyformBorders& borders, const Vec3& p) noexcept {
  // Rhombs of two triangles: columns along x, rows 60 degrees from there.
  const double v = p.z / kTriangleHeight, u = p.x - v / 2, i = std::floor(u), j = std::floor(v), x = u - i, z = v - j;
  // The nearest corner, and the sector around it in which the triangle lies.
  struct Corner {
    double column, row;
    std::size_t sector;
  };
  const bool is_upright = x + z < 1;
  const std::array<Corner, 3> corners = is_upright ? std::array<Corner, 3>{{{0, 0, 0}, {1, 0, 2}, {0, 1, 4}}}
                                                   : std::array<Corner, 3>{{{1, 0, 1}, {1, 1, 3}, {0, 1, 5}}};
  const auto distance = [x, z](const Corner& c) {
    const double du = x - c.column, dv = z - c.row;
    return du * du + du * dv + dv * dv;
  };
  const Corner& corner = *std::ranges::min_element(corners, {}, distance);
  std::array<bool, 6> edges = edges_around(borders, i + corner.column, j + corner.row);
  std::rotate(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(corner.sector), edges.end());
  static constexpr double kCos[] = {1, 0.5, -0.5, -1, -0.5, 0.5},
                          kSin[] = {0, kTriangleHeight, kTriangleHeight, 0, -kTriangleHeight, -kTriangleHeight};
  const double dz = (z - corner.row) * kTriangleHeight, dx = x - corner.column + (z - corner.row) / 2;
  const double cosine = kCos[corner.sector], sine = kSin[corner.sector];
  CornerPoint point{dx * cosine + dz * sine, dz * cosine - dx * sine};
  if (edges[0] && edges[1]) return end_of_triangle(o.exterior, point);
  if (edges[0] || edges[1]) {
    // With one sector more the polyform's corner is one of 120 degrees; beyond that it is straight or hollow.
    const bool is_turn = edges[0] ? edges[2] : edges[5];
    if (!edges[0]) point = about_other_edge(point);
    return turned(is_turn ? o.form : 0, point);
  }
  return std::ranges::find(edges, true) == edges.end() ? 0 : hollow(o.interior, point);
}

// ---- Hexagons -------------------------------------------------------------------------------------------------------

/// Two corners of each hexagon lie along x, the left one of the first in the origin. Columns are 1.5 apart, each half a
/// hexagon higher than the one before.
Vec3 middle_of(double i, double j) noexcept { return {1 + 1.5 * i, 0, kTriangleHeight * (i + 2 * j)}; }

/// The neighbours' places, from 30 degrees on, each 60 degrees further.
constexpr double kNeighbours[6][2] = {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}};

struct Hexagon {
  double column, row;
};

/// The edges of one hexagon, each looked up when it is first asked for: points near one another ask for the same.
class HexagonEdges {
 public:
  HexagonEdges(const PolyformBorders& borders, const Hexagon& hexagon) noexcept
      : borders_(borders), hexagon_(hexagon), middle_(middle_of(hexagon.column, hexagon.row)) {}

  [[nodiscard]] const Vec3& middle() const { return middle_; }
  /// True if no other hexagon is nearer: p is within the circle inscribed in this one.
  [[nodiscard]] bool surely_holds(const Vec3& p) const {
    const double x = p.x - middle_.x, z = p.z - middle_.z;
    return x * x + z * z < kTriangleHeight * kTriangleHeight;
  }
  /// Edge k is that to neighbour k.
  [[nodiscard]] bool is_border(int k) noexcept {
    const unsigned bit = 1U << k;
    if ((known_ & bit) == 0) {
      known_ |= bit;
      if (look_up(k)) border_ |= bit;
    }
    return (border_ & bit) != 0;
  }

 private:
  [[nodiscard]] bool look_up(int k) const noexcept {
    if (k < 3) return borders_(hexagon_.column, hexagon_.row, k);
    return borders_(hexagon_.column + kNeighbours[k][0], hexagon_.row + kNeighbours[k][1], k - 3);
  }

  const PolyformBorders& borders_;
  Hexagon hexagon_;
  Vec3 middle_;
  unsigned known_ = 0, border_ = 0;
};

Hexagon hexagon_at(const Vec3& p) noexcept {
  const double i = std::round((p.x - 1) / 1.5), j = std::round((p.z / kTriangleHeight - i) / 2);
  const auto distance = [&p](double column, double row) {
    const Vec3 middle = middle_of(column, row);
    return (p.x - middle.x) * (p.x - middle.x) + (p.z - middle.z) * (p.z - middle.z);
  };
  // The nearest hexagon is the first guess or a neighbour of it.
  Hexagon nearest{i, j};
  double least = distance(i, j);
  // No other one is nearer to a place within the circle inscribed in a hexagon.
  if (least < kTriangleHeight * kTriangleHeight) return nearest;
  for (const auto& [di, dj] : kNeighbours) {
    const double other = distance(i + di, j + dj);
    if (other >= least) continue;
    least = other;
    nearest = {i + di, j + dj};
  }
  return nearest;
}

double in_hexagon(const Pavement& o, HexagonEdges& edges, const Vec3& p) noexcept {
  // The corner that is nearest: corner k lies at 60 k degrees, between the edges k − 1 and k. Seen from it towards the
  // middle, edge k − 1 is on the left. `ahead` and `left` are the point's offset from the corner.
  static constexpr double kCos[] = {1, 0.5, -0.5, -1, -0.5, 0.5},
                          kSin[] = {0, kTriangleHeight, kTriangleHeight, 0, -kTriangleHeight, -kTriangleHeight};
  const double x = p.x - edges.middle().x, z = p.z - edges.middle().z;
  // Along the ways to the corners 0 to 2; those to the other three are opposite.
  const double outward[] = {x, 0.5 * x + kTriangleHeight * z, -0.5 * x + kTriangleHeight * z};
  int way = std::abs(outward[1]) > std::abs(outward[0]) ? 1 : 0;
  if (std::abs(outward[2]) > std::abs(outward[way])) way = 2;
  const double most = std::abs(outward[way]);
  const int k = outward[way] < 0 ? way + 3 : way;
  const double ahead = 1 - most, left = x * kSin[k] - z * kCos[k];
  const bool is_left = edges.is_border((k + 5) % 6), is_right = edges.is_border(k);
  if (!is_left && !is_right) return 0;
  const CornerPoint from_left{0.5 * ahead + kTriangleHeight * left, kTriangleHeight * ahead - 0.5 * left};
  const CornerPoint from_right{0.5 * ahead - kTriangleHeight * left, kTriangleHeight * ahead + 0.5 * left};
  if (is_left && is_right) return turned(o.form, from_left.away < from_right.away ? from_left : from_right);
  // One border and one edge within the polyform: the third edge of the corner is a border, and the corner hollow. Its
  // half beside the border is as along a straight one.
  const double from_border = is_left ? -left : left;
  if (from_border <= 0) return fading((is_left ? from_left : from_right).away, kInradius);
  return hollow(o.interior, {ahead, from_border});
}

double pavement_at(const PatternPoint& at) noexcept {
  const Pavement& o = at.operands<Pavement>();
  const PolyformBorders borders(o.sides, o.tiles, o.pattern);
  if (o.sides == 4) return squares(o, borders, at.point);
  if (o.sides == 3) return triangles(o, borders, at.point);
  HexagonEdges edges(borders, hexagon_at(at.point));
  return in_hexagon(o, edges, at.point);
}

void pavement_near(const PatternPoint& at, std::span<const Vec3> points, std::span<double> values) noexcept {
  const Pavement& o = at.operands<Pavement>();
  const PolyformBorders borders(o.sides, o.tiles, o.pattern);
  HexagonEdges edges(borders, hexagon_at(at.point));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    if (o.sides == 4) {
      values[i] = squares(o, borders, p);
    } else if (o.sides == 3) {
      values[i] = triangles(o, borders, p);
    } else if (edges.surely_holds(p)) {
      values[i] = in_hexagon(o, edges, p);
    } else {
      HexagonEdges other(borders, hexagon_at(p));
      values[i] = in_hexagon(o, other, p);
    }
  }
}

// ---- Operands -------------------------------------------------------------------------------------------------------

void read_sides(scene::OperandReader& reader, Pavement& pavement) noexcept {
  pavement.sides = static_cast<int>(reader.number("`number_of_sides`"));
  if (pavement.sides != 3 && pavement.sides != 4 && pavement.sides != 6)
    reader.fail(fmt::format("`number_of_sides` must be 3, 4 or 6, found {}", pavement.sides));
}

/// POV-Ray takes any other number for 0.
int read_pavement_kind(scene::OperandReader& reader, std::string_view word, int most) noexcept {
  const double kind = reader.number(fmt::format("`{}`", word));
  if (kind >= 0 && kind < most + 1) return static_cast<int>(kind);
  reader.warn(fmt::format("`{}` must be from 0 to {}, found {:g}; 0 is taken", word, most, kind));
  return 0;
}

void read_pavement_form(scene::OperandReader& reader, Pavement& pavement) noexcept {
  pavement.form = read_pavement_kind(reader, "form", 3);
}
void read_pavement_interior(scene::OperandReader& reader, Pavement& pavement) noexcept {
  pavement.interior = read_pavement_kind(reader, "interior", 2);
}
void read_pavement_exterior(scene::OperandReader& reader, Pavement& pavement) noexcept {
  pavement.exterior = read_pavement_kind(reader, "exterior", 2);
}

constexpr int kMostTiles = 6, kMostPolyforms = 35;

constexpr scene::OperandField kPavement[] = {
    scene::modifier<&Pavement::sides>("number_of_sides").read_by<read_sides>(),
    scene::modifier<&Pavement::tiles>("number_of_tiles").within(1, kMostTiles),
    scene::modifier<&Pavement::pattern>("pattern").within(1, kMostPolyforms).with_key("number"),
    scene::modifier<&Pavement::form>("form").read_by<read_pavement_form>(),
    scene::modifier<&Pavement::interior>("interior").read_by<read_pavement_interior>(),
    scene::modifier<&Pavement::exterior>("exterior").read_by<read_pavement_exterior>()};

void check_polyform(scene::OperandReader& reader, const Pavement& o) noexcept {
  const int count = polyform_count(o.sides, o.tiles);
  if (count == 0) {
    reader.fail(fmt::format("`number_of_tiles` is at most 5 for {} sides, found {}", o.sides, o.tiles));
  } else if (o.pattern > count) {
    reader.fail(fmt::format("`pattern` is from 1 to {} for {} tiles of {} sides, found {}", count, o.tiles, o.sides,
                            o.pattern));
  }
}

}  // namespace

constinit const PatternInfo pattern_kinds::pavement{.operands = operands_of<Pavement, kPavement>,
                                                    .check = check_operands<Pavement, check_polyform>,
                                                    .value = pavement_at,
                                                    .values_near = pavement_near};

}  // namespace isl::render
