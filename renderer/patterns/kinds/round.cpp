// Patterns of distances and angles: rings, bands, spirals. A pattern that ends at distance 1 is 1 at its middle and 0
// beyond.
#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/patterns/kinds/turbulence.h"
#include "renderer/patterns/kinds/waveform.h"
#include "renderer/values/single_precision.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

using scene::OperandField;

constexpr double kTurn = 2 * std::numbers::pi;

double fading(double distance) { return 1 - std::min(distance, 1.0); }

/// The angle about the z axis from −y towards x, in [0, 2π).
double angle_about_z(const Vec3& p) {
  const double angle = std::atan2(p.x, -p.y);
  return angle < 0 ? angle + kTurn : angle;
}

double radius_about_z(const Vec3& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

double onion_at(const PatternPoint& at) noexcept { return below_1(std::sqrt(at.point.dot(at.point))); }
double spherical_at(const PatternPoint& at) noexcept { return fading(std::sqrt(at.point.dot(at.point))); }
/// Falls with the distance from the y axis.
double cylindrical_at(const PatternPoint& at) noexcept {
  const Vec3& p = at.point;
  return fading(std::sqrt(p.x * p.x + p.z * p.z));
}
double boxed_at(const PatternPoint& at) noexcept {
  const Vec3& p = at.point;
  return fading(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
}
/// Falls with the distance from the plane y = 0.
double planar_at(const PatternPoint& at) noexcept { return fading(std::abs(at.point.y)); }

/// The angle about the y axis as a share of the full circle; 1/4 on the axis itself.
double radial_at(const PatternPoint& at) noexcept {
  constexpr double kAxisRadius = 0.001;
  const Vec3& p = at.point;
  if (std::abs(p.x) < kAxisRadius && std::abs(p.z) < kAxisRadius) return 0.25;
  return 0.25 + (std::atan2(p.x, p.z) + std::numbers::pi) / kTurn;
}

struct Gradient {
  Vec3 direction{0};  ///< unit length, or 0
};
constexpr OperandField kGradient[] = {scene::operand<&Gradient::direction>("direction")};

void read_gradient(scene::OperandReader& reader, Gradient& gradient, std::string_view /*word*/) noexcept {
  gradient.direction = reader.vector("a vector after `gradient`").normalized();
}

double gradient_at(const PatternPoint& at) noexcept { return below_1(at.point.dot(at.operands<Gradient>().direction)); }

/// ((sin x + sin y + sin z) / 3)².
double leopard_at(const PatternPoint& at) noexcept {
  const Vec3& p = at.point;
  const double mean = (std::sin(p.x) + std::sin(p.y) + std::sin(p.z)) / 3;
  return mean * mean;
}

struct Quilted {
  double control0 = 1;
  double control1 = 1;
};
constexpr OperandField kQuilted[] = {scene::modifier<&Quilted::control0>("control0"),
                                     scene::modifier<&Quilted::control1>("control1")};

/// The offset from the middle of the unit cube around p.
Vec3 from_middle(const Vec3& p) noexcept {
  return {p.x - std::floor(p.x) - 0.5, p.y - std::floor(p.y) - 0.5, p.z - std::floor(p.z) - 0.5};
}
/// A Bézier curve of the distance from the middle, with the two controls.
double swelling(const Quilted& quilted, double t) noexcept {
  const double s = 1 - t;
  return 3 * t * s * s * values::to_single(quilted.control0) + 3 * t * t * s * values::to_single(quilted.control1) +
         t * t * t;
}
/// 1/√¾ as POV-Ray writes it: the corner of the cube comes to 1 for a swelling of 1.
constexpr double kToCorner = 1.154700538;

/// In every unit cube, the value rises from the middle.
double quilted_at(const PatternPoint& at) noexcept {
  const Vec3 offset = from_middle(at.point);
  const double swollen = swelling(at.operands<Quilted>(), std::sqrt(offset.dot(offset)));
  constexpr double kScale = kToCorner / 3;
  return (std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z)) * swollen * kScale;
}
/// Away from the middle of the cube.
Vec3 bend_by_quilts(const PatternPoint& at, const Vec3& normal, double size) noexcept {
  const Vec3 offset = from_middle(at.point);
  return normal + offset * (size * kToCorner * swelling(at.operands<Quilted>(), std::sqrt(offset.dot(offset))));
}

struct Spiral {
  int arms = 0;
};
constexpr OperandField kSpiral[] = {scene::operand<&Spiral::arms>("arms")};

void read_spiral(scene::OperandReader& reader, Spiral& spiral, std::string_view /*word*/) noexcept {
  constexpr int kMaxArms = 1 << 16;
  spiral.arms = reader.whole_in("the number of arms", -kMaxArms, kMaxArms);
}

/// p.z + distance from the z axis + arms · angle about it, + turbulence.
double spiral1_at(const PatternPoint& at) noexcept {
  const Vec3& p = at.point;
  const scene::Turbulence& turbulence = at.pattern.turbulence;
  const double push =
      turbulence.amount.x == 0 ? 0 : turbulence.amount.x * turbulence_at(p, turbulence, at.noise_generator());
  return p.z + radius_about_z(p) + at.operands<Spiral>().arms * angle_about_z(p) / kTurn + push;
}

/// Two spirals that cross: triangle wave of the distance + triangle wave of spiral1.
double spiral2_at(const PatternPoint& at) noexcept {
  return triangle_wave(radius_about_z(at.point)) + triangle_wave(spiral1_at(at));
}

constexpr PatternColour kRadialColours[] = {{0, 0, 1, 1}, {0.333, 1, 1, 0}, {0.666, 1, 0, 1}, {1, 0, 1, 1}};

constexpr PatternInfo spiral(double (*value)(const PatternPoint&) noexcept) {
  return {.wave = scene::Wave::triangle,
          .operands = operands_of<Spiral, kSpiral>,
          .read = read_operands<Spiral, read_spiral>,
          .value = value};
}

}  // namespace

constinit const PatternInfo pattern_kinds::boxed{.value = boxed_at};
constinit const PatternInfo pattern_kinds::cylindrical{.value = cylindrical_at};
constinit const PatternInfo pattern_kinds::gradient{
    .operands = operands_of<Gradient, kGradient>, .read = read_operands<Gradient, read_gradient>, .value = gradient_at};
constinit const PatternInfo pattern_kinds::leopard{.value = leopard_at};
constinit const PatternInfo pattern_kinds::onion{.value = onion_at};
constinit const PatternInfo pattern_kinds::planar{.value = planar_at};
constinit const PatternInfo pattern_kinds::quilted{
    .makes_bumps = true, .operands = operands_of<Quilted, kQuilted>, .value = quilted_at, .bend = bend_by_quilts};
constinit const PatternInfo pattern_kinds::radial{.colours = kRadialColours, .value = radial_at};
constinit const PatternInfo pattern_kinds::spherical{.value = spherical_at};
constinit const PatternInfo pattern_kinds::spiral1 = spiral(spiral1_at);
constinit const PatternInfo pattern_kinds::spiral2 = spiral(spiral2_at);

}  // namespace isl::render
