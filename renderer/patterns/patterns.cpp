#include "renderer/patterns/patterns.h"

#include "renderer/patterns/block_patterns.h"
#include "renderer/patterns/cell_patterns.h"
#include "renderer/patterns/fractal_patterns.h"
#include "renderer/patterns/map_interval.h"
#include "renderer/patterns/noise_patterns.h"
#include "renderer/patterns/pigment_colour.h"
#include "renderer/patterns/round_patterns.h"
#include "renderer/patterns/warp_point.h"
#include "renderer/patterns/wave_patterns.h"
#include "renderer/patterns/waveform.h"

#include "base/check.h"

#include <cmath>

namespace isl::render {
namespace {

using scene::Colour;
using scene::Database;
using scene::Pattern;
using scene::PatternKind;
using scene::Pigment;
using values::Environment;

/// These put the turbulence into their formulas instead.
constexpr bool uses_turbulence_itself(PatternKind kind) {
  return kind == PatternKind::marble || kind == PatternKind::wood;
}

/// In the pattern's own space.
Vec3 point_of(const Database& database, const Pattern& pattern, const Vec3& point, const Environment& environment) {
  const bool is_on_surface = pattern.uv_mapping && environment.coordinates() != nullptr;
  return warped(database, pattern, is_on_surface ? *environment.coordinates() : point,
                uses_turbulence_itself(pattern.kind) ? PointTurbulence::no : PointTurbulence::yes);
}

NoiseGenerator generator_of(const Pattern& pattern, const Environment& environment) {
  return pattern.noise_generator == 0 ? environment.noise_generator()
                                      : values::noise_generator_of(pattern.noise_generator);
}

/// What POV-Ray does to patterns without a bound before they meet frequency and phase.
double below_1(double value) { return value > 1 ? std::fmod(value, 1.0) : value; }

double function_value(const Database& database, scene::FunctionId id, const Vec3& p, Environment& environment) {
  if (id == scene::kNoFunction) return 0;
  const double arguments[] = {p.x, p.y, p.z};
  const double value = values::evaluate(*database.functions[index(id)], arguments, environment)[0];
  return below_1(value);
}

/// One turbulence for the arms of spirals.
double spiral_turbulence(const Pattern& pattern, const Vec3& p, NoiseGenerator generator) {
  if (pattern.turbulence.amount.x == 0) return 0;
  return pattern.turbulence.amount.x * turbulence_at(p, pattern.turbulence, generator);
}

}  // namespace

double Patterns::pattern_value(const Pattern& pattern, const Vec3& point, Environment& environment) const noexcept {
  return look_up(pattern, point, environment).value;
}

PatternPlace Patterns::look_up(const Pattern& pattern, const Vec3& point, Environment& environment) const noexcept {
  if (!environment.take_step()) return {point, 0};
  const Vec3 p = point_of(database_, pattern, point, environment);
  return {p, in_wave(raw_value(pattern, p, environment), pattern)};
}

double Patterns::raw_value(const Pattern& pattern, const Vec3& p, Environment& environment) const noexcept {
  const NoiseGenerator generator = generator_of(pattern, environment);
  const auto& operands = pattern.operands;
  switch (pattern.kind) {
    case PatternKind::agate:
      return agate(p, pattern.turbulence, std::get<scene::AgateOperands>(operands).turbulence, generator);
    case PatternKind::boxed: return boxed(p);
    case PatternKind::bozo:
    case PatternKind::bumps:
    case PatternKind::spotted: return bozo(p, generator);
    case PatternKind::brick: return brick(p, std::get<scene::BrickOperands>(operands));
    case PatternKind::cells: return cells(p);
    case PatternKind::checker: return checker(p);
    case PatternKind::crackle: return crackle(p, std::get<scene::CrackleOperands>(operands), generator);
    case PatternKind::cubic: return cubic(p);
    case PatternKind::cylindrical: return cylindrical(p);
    case PatternKind::dents: return dents(p, generator);
    case PatternKind::fractal: return fractal(p, std::get<scene::FractalOperands>(operands));
    case PatternKind::function:
      return function_value(database_, std::get<scene::FunctionOperands>(operands).function, p, environment);
    case PatternKind::gradient: return below_1(gradient(p, std::get<scene::GradientOperands>(operands).direction));
    case PatternKind::granite: return granite(p, generator);
    case PatternKind::hexagon: return hexagon(p);
    case PatternKind::leopard: return leopard(p);
    case PatternKind::marble: return marble(p, pattern.turbulence, generator);
    case PatternKind::object: {
      const std::uint32_t object = std::get<scene::ObjectOperands>(operands).object;
      return object != scene::kNone && surroundings_->is_inside(database_.pattern_objects[object], p) ? 1 : 0;
    }
    case PatternKind::onion: return below_1(onion(p));
    case PatternKind::pigment_pattern: {
      const Pigment pigment{.pattern = std::get<scene::PigmentOperands>(operands).pigment};
      return gray(pigment_colour(pigment, p, environment));
    }
    case PatternKind::planar: return planar(p);
    case PatternKind::quilted: return quilted(p, std::get<scene::QuiltedOperands>(operands));
    case PatternKind::radial: return radial(p);
    case PatternKind::ripples: return ripples(p, pattern, number_of_waves_);
    case PatternKind::spherical: return spherical(p);
    case PatternKind::spiral1:
      return spiral1(p, std::get<scene::SpiralOperands>(operands).arms, spiral_turbulence(pattern, p, generator));
    case PatternKind::spiral2:
      return spiral2(p, std::get<scene::SpiralOperands>(operands).arms, spiral_turbulence(pattern, p, generator));
    case PatternKind::square: return square(p);
    case PatternKind::triangular: return triangular(p);
    case PatternKind::waves: return waves(p, pattern, number_of_waves_);
    case PatternKind::wood: return wood(p, pattern.turbulence);
    case PatternKind::wrinkles: return wrinkles(p, generator);
    // Of the surface, of a list, or of a file: see is_known().
    case PatternKind::plain:
    case PatternKind::aoi:
    case PatternKind::average:
    case PatternKind::bump_map:
    case PatternKind::density_file:
    case PatternKind::facets:
    case PatternKind::image_map:
    case PatternKind::image_pattern:
    case PatternKind::material_map:
    case PatternKind::pavement:
    case PatternKind::slope:
    case PatternKind::tiling: return 0;
  }
  ISL_CHECK(false, "pattern {}", static_cast<int>(pattern.kind));
}

Colour Patterns::pigment_colour(const Pigment& pigment, const Vec3& point, Environment& environment) const noexcept {
  if (pigment.is_plain()) return in_single(pigment.colour);
  const scene::PatternedPigment& record = database_.pigments[index(pigment.pattern)];
  if (record.pattern.kind == PatternKind::plain) return in_single(record.colour);
  if (!environment.take_step()) return {};
  const Vec3 p = point_of(database_, record.pattern, point, environment);
  const scene::PigmentMap& map = database_.pigment_maps[index(record.map)];
  if (record.pattern.kind == PatternKind::average) return average(map, p, environment);
  const double value = in_wave(raw_value(record.pattern, p, environment), record.pattern);
  const auto interval = find_in(map, value);
  const Colour second = pigment_colour(interval.second->pigment, p, environment);
  if (interval.first == interval.second) return second;
  return blend(pigment_colour(interval.first->pigment, p, environment), second, interval.fraction);
}

Colour Patterns::average(const scene::PigmentMap& map, const Vec3& p, Environment& environment) const noexcept {
  WeightedMean mean;
  for (const scene::PigmentEntry& entry : map) mean.add(pigment_colour(entry.pigment, p, environment), entry.value);
  return mean.colour();
}

}  // namespace isl::render
