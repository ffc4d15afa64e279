#include "renderer/patterns/patterns.h"

#include "renderer/patterns/kinds/pigment_colour.h"
#include "renderer/patterns/kinds/waveform.h"
#include "renderer/patterns/map_interval.h"
#include "renderer/patterns/own_space.h"

namespace isl::render {
namespace {

using scene::Colour;
using scene::Database;
using scene::Pattern;
using scene::PatternKind;
using scene::Pigment;
using values::Environment;

/// Entries of a map that are looked through in the time of a step.
constexpr std::size_t kEntriesOfStep = 256;

}  // namespace

double Patterns::value_at_own_point(const Pattern& pattern, const Vec3& p, Environment& environment) const noexcept {
  return in_wave(raw_value(pattern, p, environment), pattern);
}

double Patterns::pattern_value(const Pattern& pattern, const Vec3& point, Environment& environment) const noexcept {
  return look_up(pattern, point, environment).value;
}

PatternPlace Patterns::look_up(const Pattern& pattern, const Vec3& point, Environment& environment) const noexcept {
  if (!environment.take_step()) return {point, 0};
  const Vec3 p = own_point(world_.database, pattern, point, environment);
  return {p, value_at_own_point(pattern, p, environment)};
}

double Patterns::raw_value(const Pattern& pattern, const Vec3& p, Environment& environment) const noexcept {
  const auto value = info_of(pattern.kind).value;
  return value ? value({pattern, p, environment, world_}) : 0;
}

void Patterns::values_near(const Pattern& pattern, const Vec3& p, std::span<const Vec3> points,
                           std::span<double> values, Environment& environment) const noexcept {
  const PatternInfo& info = info_of(pattern.kind);
  if (info.values_near) return info.values_near({pattern, p, environment, world_}, points, values);
  for (std::size_t i = 0; i < points.size(); ++i)
    values[i] = info.value ? info.value({pattern, points[i], environment, world_}) : 0;
}

Colour Patterns::pigment_colour(const Pigment& pigment, const Vec3& point, Environment& environment) const noexcept {
  if (pigment.is_plain()) return in_single(pigment.colour);
  const scene::PatternedPigment& record = world_.database.pigments[index(pigment.pattern)];
  if (record.pattern.kind == PatternKind::plain) return in_single(record.colour);
  if (!environment.take_step()) return {};
  const Vec3 p = own_point(world_.database, record.pattern, point, environment);
  if (const auto colour = info_of(record.pattern.kind).colour) return colour({record.pattern, p, environment, world_});
  const scene::PigmentMap& map = world_.database.pigment_maps[index(record.map)];
  if (!environment.steps().take(map.size() / kEntriesOfStep)) return {};
  if (info_of(record.pattern.kind).choice == PatternChoice::mean_of_map) return average(map, p, environment);
  const double value = value_at_own_point(record.pattern, p, environment);
  const auto interval = find_in(map, value);
  // A map of colours is the common case. Blending rounds them to single precision, too.
  const Pigment &first = interval.first->pigment, &second = interval.second->pigment;
  const auto colour_of = [&](const Pigment& other) {
    return other.is_plain() ? other.colour : pigment_colour(other, p, environment);
  };
  if (&first == &second) return second.is_plain() ? in_single(second.colour) : pigment_colour(second, p, environment);
  const Colour colour = colour_of(second);
  return blend(colour_of(first), colour, interval.fraction);
}

Colour Patterns::average(const scene::PigmentMap& map, const Vec3& p, Environment& environment) const noexcept {
  WeightedMean mean;
  for (const scene::PigmentEntry& entry : map) {
    if (environment.is_spent()) return {};
    mean.add(pigment_colour(entry.pigment, p, environment), entry.value);
  }
  return mean.colour();
}

}  // namespace isl::render
