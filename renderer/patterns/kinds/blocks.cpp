// Patterns that choose from a list; their value is the item's index, from 0 on.
#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/values/integer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>

namespace isl::render {
namespace {

using scene::OperandField;
using values::is_odd;

/// POV-Ray's offset of points, so that a plane through the lattice lies on one side.
constexpr double kSmall = 1e-10;

double fraction(double v) { return v - std::floor(v); }
double positive_remainder(double whole, double divisor) {
  const double remainder = std::fmod(whole, divisor);
  return remainder < 0 ? remainder + divisor : remainder + 0.0;  // and no negative zero
}

/// Numbers from here on are whole, and so are their sums in double precision only by rounding.
constexpr double kWhole = 0x1p52;

/// The floor of a number that is smaller than kWhole, which takes a processor without an instruction for it a third of
/// the time of std::floor.
std::int64_t floor_of(double v) {
  const auto whole = static_cast<std::int64_t>(v);
  return whole - (v < static_cast<double>(whole) ? 1 : 0);
}

/// Unit cubes with alternating values 0 and 1.
double checker_at(const PatternPoint& at) noexcept {
  const Vec3 p = at.point + Vec3(kSmall);
  if (std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < kWhole) [[likely]]
    return static_cast<double>((floor_of(p.x) + floor_of(p.y) + floor_of(p.z)) & 1);
  return is_odd(std::floor(p.x) + std::floor(p.y) + std::floor(p.z)) ? 1 : 0;
}

struct Brick {
  Vec3 size{8, 3, 4.5};
  double mortar = 0.5;
};
constexpr OperandField kBrick[] = {scene::modifier<&Brick::size>("brick_size"),
                                   scene::modifier<&Brick::mortar>("mortar")};

/// 1 in a brick, 0 in the mortar. Layers of bricks along y, every other one moved by half a brick.
double brick_at(const PatternPoint& at) noexcept {
  const Vec3& p = at.point;
  const Brick& operands = at.operands<Brick>();
  const Vec3 q((p.x + kSmall) / operands.size.x, (p.y + kSmall) / operands.size.y, (p.z + kSmall) / operands.size.z);
  const Vec3 mortar(operands.mortar / operands.size.x, operands.mortar / operands.size.y,
                    operands.mortar / operands.size.z);
  if (fraction(q.y) >= 1 - mortar.y) return 0;
  const bool is_lower = fraction(q.y * 0.5) <= 0.5;
  if (fraction(q.x + (is_lower ? 0 : 0.5)) >= 1 - mortar.x) return 0;
  if (fraction(q.z + (is_lower ? 0.5 : 0)) >= 1 - mortar.z) return 0;
  return 1;
}

/// The index of the half-axis nearest to the point, in the order x, y, z, −x, −y, −z.
double cubic_at(const PatternPoint& at) noexcept {
  const Vec3& p = at.point;
  const double along[] = {p.x, p.y, p.z, -p.x, -p.y, -p.z};
  return static_cast<double>(std::max_element(std::begin(along), std::end(along)) - std::begin(along));
}

// Regular hexagons of side 1 in the plane of x and z, no two neighbours equal, by their axial coordinates: centres at
// (1.5 q, √3 (r + q/2)). The nearest is found by rounding all three cube coordinates and mending the one that was
// rounded most.
double hexagon_at(const PatternPoint& at) noexcept {
  const Vec3& p = at.point;
  // POV-Ray's √3; and what lies on a border at z = 0 belongs to the hexagon above and outward, left and right alike.
  constexpr double kSqrt3 = 5.196152424 / 3, kOutward = 1e-12, kUp = 1e-12;
  const double q = (std::abs(p.x) + kOutward) / 1.5, r = (p.z + kUp) / kSqrt3 - q / 2, s = -q - r;
  double whole_q = std::round(q), whole_r = std::round(r);
  const double error_q = std::abs(whole_q - q), error_r = std::abs(whole_r - r), error_s = std::abs(std::round(s) - s);
  if (error_q > error_r && error_q > error_s) {
    whole_q = -whole_r - std::round(s);
  } else if (error_r > error_s) {
    whole_r = -whole_q - std::round(s);
  }
  return positive_remainder(whole_r - whole_q, 3);
}

/// Unit squares in the plane of x and z.
double square_at(const PatternPoint& at) noexcept {
  const Vec3& p = at.point;
  const bool odd_x = is_odd(std::floor(p.x)), odd_z = is_odd(std::floor(p.z));
  return odd_x ? (odd_z ? 2 : 3) : (odd_z ? 1 : 0);
}

// Triangles of side 1 in the plane of x and z. In each row of height √¾ triangles stand on their bases, others between
// them on their tips; a row up, all are moved by half a base.
double triangular_at(const PatternPoint& at) noexcept {
  const Vec3& p = at.point;
  constexpr double kHeight = std::numbers::sqrt3 / 2;
  constexpr int kOnBase[2][3] = {{0, 4, 2}, {2, 0, 4}};  // by the row's parity, and the base's number
  constexpr int kOnTip[2][3] = {{1, 3, 5}, {5, 1, 3}};   // by the tip's number
  const double row = std::floor(p.z / kHeight), up = p.z / kHeight - row;
  const std::size_t parity = is_odd(row) ? 1 : 0;
  const double along = p.x - (parity == 0 ? 0 : 0.5), base = std::floor(along), from_base = along - base;
  if (from_base > up / 2 && from_base <= 1 - up / 2)
    return kOnBase[parity][static_cast<std::size_t>(positive_remainder(base, 3))];
  if (std::isnan(from_base + up)) return 0;
  const double tip = from_base <= up / 2 ? base : base + 1;
  return kOnTip[parity][static_cast<std::size_t>(positive_remainder(tip, 3))];
}

/// Default lists; a list with fewer items takes the first ones.
constexpr PatternColour kBricks[] = {{0, 0.5, 0.5, 0.5}, {1, 0.6, 0.15, 0.15}};
constexpr PatternColour kTiles[] = {{0, 0, 0, 1}, {1, 0, 1, 0}, {2, 1, 0, 0}};
constexpr PatternColour kPolygons[] = {{0, 1, 0, 0}, {1, 0, 1, 0}, {2, 0, 0, 1},
                                       {3, 1, 1, 0}, {4, 0, 1, 1}, {5, 1, 0, 1}};

constexpr PatternInfo list_of(std::span<const PatternColour> colours, double (*value)(const PatternPoint&) noexcept) {
  return {.choice = PatternChoice::list,
          .list_length = static_cast<int>(colours.size()),
          .colours = colours,
          .value = value};
}

double object_at(const PatternPoint& at) noexcept {
  const std::uint32_t object = std::get_if<scene::ObjectOperands>(&at.pattern.operands)->object;
  if (object == scene::kNone) return 0;
  return at.world.surroundings->is_inside(at.world.database.pattern_objects[object], at.point, at.environment.steps())
             ? 1
             : 0;
}

}  // namespace

constinit const PatternInfo pattern_kinds::brick = [] {
  PatternInfo info = list_of(kBricks, brick_at);
  info.operands = operands_of<Brick, kBrick>;
  return info;
}();
constinit const PatternInfo pattern_kinds::checker = list_of(std::span(kTiles).first(2), checker_at);
constinit const PatternInfo pattern_kinds::cubic = list_of(kPolygons, cubic_at);
constinit const PatternInfo pattern_kinds::hexagon = list_of(kTiles, hexagon_at);
constinit const PatternInfo pattern_kinds::object = [] {
  PatternInfo info = list_of(std::span(kTiles).first(2), object_at);
  info.block = PatternBlock::object;
  return info;
}();
constinit const PatternInfo pattern_kinds::square = list_of(std::span(kPolygons).first(4), square_at);
constinit const PatternInfo pattern_kinds::triangular = list_of(kPolygons, triangular_at);

}  // namespace isl::render
