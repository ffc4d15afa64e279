// The properties. Tolerances are in units of what a field computed in double precision may lose: a relative error of
// the result, plus the change of the result when the point moves by a relative error of its coordinates.
#include "tests/conformance/properties.h"

#include "renderer/reference/reference_field.h"
#include "tests/conformance/witnesses.h"
#include "tests/reference/random_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace isl::conformance {
namespace {

using reference::exactly;
using reference::FieldSample;
using reference::RandomSource;
using reference::ReferenceComponent;

/// Number of points for a field and a property; few suffice, since there are hundreds of fields.
constexpr int kPoints = 8;

/// 2e-13 is some 900 units in the last place. It allows for tens of operations, and for an exponential of an argument
/// of up to 500, in which one unit in the last place is 500 units of the result.
constexpr double kRounding = 2e-13;

std::string text(const Vec3& p) { return fmt::format("<{:.17g}, {:.17g}, {:.17g}>", p.x, p.y, p.z); }

/// The reference's field. It is made once for each property, because a kernel's constants take time to solve.
ReferenceComponent truth_of(const FieldCase& field) {
  return {field.component,
          std::make_shared<const reference::KernelInUse>(field.kernel),
          field.transform,
          {&field.third_corner, 1}};
}

double length_of(const reference::Vector<long double>& v) { return static_cast<double>(std::sqrt(squared_length(v))); }

/// The size of values next to the surface that the component has alone.
double unit_of(const FieldCase& field) { return std::abs(field.component.strength); }

/// The shortest length over which the field changes: its radius over the hardness of its border, stretched.
double feature_size(const FieldCase& field) {
  double least = field.component.radius_a;
  if (field.component.skeleton == scene::Skeleton::cone) least = std::min(least, field.component.radius_b);
  const double hardness = field.kernel.meaning == scene::RadiusMeaning::support ? 1 : field.kernel.hardness;
  return least / 2 / std::max(hardness, 1.0);
}

/// √Q: the end of the support, in radii.
double border_of(const FieldCase& field) {
  return std::sqrt(static_cast<double>(reference::ReferenceKernel(field.kernel).support().middle()));
}

/// Points that matter: half of them next to the surface, the others anywhere.
Vec3 interesting_point(RandomSource& random, const FieldCase& field) {
  if (random.below(2) == 0) return random.in_ball(field.reach);
  const std::vector<SurfaceWitness> witness = surface_witnesses(field, 1 + random.below(20));
  const double distance = witness.back().radius * random.between(0, 1.4);
  return field.transform.point(witness.back().centre + witness.back().direction * distance);
}

std::string value_is_the_references(const FieldUnderTest& tested, const FieldCase& field) {
  RandomSource random(101);
  const ReferenceComponent judge = truth_of(field);
  for (int i = 0; i < kPoints; ++i) {
    const Vec3 p = interesting_point(random, field);
    const FieldSample truth = judge.sample(exactly(p));
    const double expected = static_cast<double>(truth.value), actual = tested.value(p);
    const double moved = length_of(truth.gradient) * (field.reach + p.length());
    const double tolerance = kRounding * (std::abs(expected) + moved + 0.01 * unit_of(field));
    if (!(std::abs(actual - expected) <= tolerance)) {
      return fmt::format("at {}: {:.17g}, the reference has {:.17g}", text(p), actual, expected);
    }
  }
  return {};
}

std::string gradient_is_the_references(const FieldUnderTest& tested, const FieldCase& field) {
  RandomSource random(102);
  const ReferenceComponent judge = truth_of(field);
  for (int i = 0; i < kPoints; ++i) {
    const Vec3 p = interesting_point(random, field);
    const reference::Vector<long double> expected = judge.sample(exactly(p)).gradient;
    const Vec3 actual = tested.gradient(p);
    // Moving p by a relative 1e-16 moves the gradient by its own relative change over the feature size.
    const double sensitivity = 1 + (field.reach + p.length()) / feature_size(field);
    const double tolerance =
        kRounding * sensitivity * (length_of(expected) + 0.01 * unit_of(field) / feature_size(field));
    if (!(length_of(exactly(actual) - expected) <= tolerance)) {
      return fmt::format("at {}: {}, the reference has <{}, {}, {}>", text(p), text(actual),
                         static_cast<double>(expected.x), static_cast<double>(expected.y),
                         static_cast<double>(expected.z));
    }
  }
  return {};
}

std::string gradient_is_the_slope_of_the_value(const FieldUnderTest& tested, const FieldCase& field) {
  RandomSource random(103);
  for (int i = 0; i < kPoints; ++i) {
    const Vec3 p = interesting_point(random, field), direction = random.direction();
    // A central difference is off by step² and by the value's rounding over step; this step keeps both small.
    const double step = feature_size(field) * 1e-4;
    const double high = tested.value(p + direction * step), low = tested.value(p - direction * step);
    const double difference = (high - low) / (2 * step), expected = tested.gradient(p).dot(direction);
    const double size = std::max({std::abs(high), std::abs(low), unit_of(field)}) / feature_size(field);
    // At the border of the support or of a skeleton's piece the second derivative jumps, which is an error of first
    // order in the step.
    if (!(std::abs(difference - expected) <= 1e-3 * (size + tested.gradient(p).length()))) {
      return fmt::format("at {} towards {}: gradient {:.17g}, difference {:.17g}", text(p), text(direction), expected,
                         difference);
    }
  }
  return {};
}

std::string surface_alone_is_at_the_radius(const FieldUnderTest& tested, const FieldCase& field) {
  if (field.kernel.meaning != scene::RadiusMeaning::surface || !is_function_of_distance(field)) return {};
  for (const SurfaceWitness& witness : surface_witnesses(field, kPoints)) {
    double low = 0.5, high = 1.5;  // shares of the radius; f falls from one to the other
    for (int step = 0; step < 60; ++step) {
      const double middle = (low + high) / 2;
      const Vec3 p = field.transform.point(witness.centre + witness.direction * (witness.radius * middle));
      (tested.value(p) / field.component.strength > 1 ? low : high) = middle;
    }
    // p itself is rounded: relative to the skeleton, by the size of the coordinates over the radius.
    const double tolerance = 1e-13 + 1e-15 * field.reach / (witness.radius * 0.1);
    if (!(std::abs(low - 1) <= std::min(tolerance, 1e-12))) {
      return fmt::format("from {} towards {}: at {:.17g} of the radius", text(witness.centre), text(witness.direction),
                         low);
    }
  }
  return {};
}

std::string slope_at_the_radius_is_minus_hardness(const FieldUnderTest& tested, const FieldCase& field) {
  if (field.kernel.meaning != scene::RadiusMeaning::surface || !is_function_of_distance(field)) return {};
  for (const SurfaceWitness& witness : surface_witnesses(field, kPoints)) {
    const Vec3 p = field.transform.point(witness.centre + witness.direction * witness.radius);
    const double value = tested.value(p) / field.component.strength;
    // Along centre + r·√q·direction: dq/dx = 2/r at q = 1, so −h = ∇f·direction·r/2.
    const double outward = tested.gradient(p).dot(field.transform.vector(witness.direction)) / field.component.strength;
    const double slope = outward * witness.radius / 2;
    const double tolerance = 1e-12 * (1 + field.kernel.hardness);
    if (!(std::abs(value - 1) <= tolerance)) return fmt::format("at {}: value {:.17g}", text(p), value);
    if (!(std::abs(slope / field.kernel.hardness + 1) <= tolerance)) {
      return fmt::format("at {}: slope {:.17g} for hardness {}", text(p), slope, field.kernel.hardness);
    }
  }
  return {};
}

std::string border_has_no_value_and_no_slope(const FieldUnderTest& tested, const FieldCase& field) {
  const double border = border_of(field);
  const double scale = unit_of(field);
  for (const SurfaceWitness& witness : surface_witnesses(field, kPoints, border)) {
    const auto at = [&](double fraction) {
      return field.transform.point(witness.centre + witness.direction * (witness.radius * border * fraction));
    };
    const Vec3 outside = at(1 + 1e-9), far = at(2);
    for (const Vec3& p : {outside, far}) {
      if (tested.value(p) != 0 || tested.gradient(p).length() != 0)
        return fmt::format("something is left at {}", text(p));
    }
    const Vec3 inside = at(1 - 1e-9);
    const double value = std::abs(tested.value(inside)), slope = tested.gradient(inside).length() * feature_size(field);
    if (!(value <= 1e-9 * scale && slope <= 1e-6 * scale)) {
      return fmt::format("at {} just inside: value {}, slope {}", text(inside), value, slope);
    }
    if (tested.value(at(0.99)) == 0) return fmt::format("nothing at {} inside the support", text(at(0.99)));
  }
  return {};
}

/// A ray from outside through a point that matters, with a direction that is not of unit length.
struct ProbeRay {
  Vec3 origin, direction;
  double t;  ///< t of that point
};

ProbeRay probe_ray(RandomSource& random, const FieldCase& field) {
  const Vec3 origin = random.direction() * (2 * field.reach), towards = interesting_point(random, field);
  const double length = random.between(0.5, 2);
  return {origin, (towards - origin).normalized() * length, (towards - origin).length() / length};
}

std::string along_a_ray_is_the_value_and_its_derivative(const FieldUnderTest& tested, const FieldCase& field) {
  RandomSource random(104);
  for (int i = 0; i < kPoints; ++i) {
    const ProbeRay ray = probe_ray(random, field);
    const double t = i % 4 == 0 ? random.between(0, 2) * ray.t : ray.t;
    const Vec3 p = ray.origin + ray.direction * t;
    const ValueAndDerivative actual = tested.along_ray(ray.origin, ray.direction, t);
    const double value = tested.value(p), derivative = tested.gradient(p).dot(ray.direction);
    const double gradient = tested.gradient(p).length();
    const double sensitivity = 1 + 4 * field.reach / feature_size(field);
    if (!(std::abs(actual.value - value) <=
          kRounding * (std::abs(value) + gradient * 4 * field.reach + 0.01 * unit_of(field)))) {
      return fmt::format("at {}: {:.17g}, value {:.17g}", text(p), actual.value, value);
    }
    const double size = (gradient + 0.01 * unit_of(field) / feature_size(field)) * ray.direction.length();
    if (!(std::abs(actual.derivative - derivative) <= kRounding * sensitivity * size)) {
      return fmt::format("at {}: derivative {:.17g}, gradient {:.17g}", text(p), actual.derivative, derivative);
    }
  }
  return {};
}

/// The field is C¹ at its critical places, the border of the support and the skeleton's ends: over steps of a
/// thousandth of the feature size the value follows the trapezium rule, and the derivative changes as little as a
/// bounded second derivative allows.
std::string is_smooth_along_rays(const FieldUnderTest& tested, const FieldCase& field) {
  RandomSource random(105);
  const auto at_border = surface_witnesses(field, kPoints, border_of(field));
  const auto at_ends = end_witnesses(field, kPoints);
  for (int i = 0; i < 2 * kPoints; ++i) {
    const bool border = i < kPoints;
    const SurfaceWitness& witness = border ? at_border[i] : at_ends[i - kPoints];
    const double level = border ? border_of(field) : 1;
    const Vec3 place = field.transform.point(witness.centre + witness.direction * (witness.radius * level));
    const Vec3 direction = random.direction() * random.between(0.5, 2);
    const double length = direction.length(), step = feature_size(field) * 1e-3 / length;
    const Vec3 origin = place - direction * (field.reach / length);
    const double start = field.reach / length - 50 * step;
    ValueAndDerivative last = tested.along_ray(origin, direction, start);
    for (int k = 1; k <= 100; ++k) {
      const ValueAndDerivative next = tested.along_ray(origin, direction, start + k * step);
      const double scale = std::max({std::abs(last.value), std::abs(next.value), unit_of(field)});
      const double trapezium = (last.derivative + next.derivative) / 2 * step;
      if (!(std::abs(next.value - last.value - trapezium) <= 1e-4 * scale)) {
        return fmt::format("the value jumps from {} to {} near {}", last.value, next.value, text(place));
      }
      if (!(std::abs(next.derivative - last.derivative) <= 0.1 * scale / feature_size(field) * length)) {
        return fmt::format("the derivative jumps from {} to {} near {}", last.derivative, next.derivative, text(place));
      }
      last = next;
    }
  }
  return {};
}

std::string box_range_holds_every_sample(const FieldUnderTest& tested, const FieldCase& field) {
  RandomSource random(106);
  const ReferenceComponent judge = truth_of(field);
  // Many a box about what is flat has the extremes at two of its corners, where any bound that knows corners is right.
  for (int i = 0; i < 3 * kPoints; ++i) {
    const Vec3 centre = interesting_point(random, field);
    const Vec3 half = Vec3(random.between(0.1, 1), random.between(0.1, 1), random.between(0.1, 1)) *
                      (field.reach * std::pow(10, random.between(-3, -0.3)));
    const ValueRange range = tested.range_over_box(centre - half, centre + half);
    for (int k = 0; k < 100; ++k) {
      // Extremes lie in corners and edges.
      const auto side = [&] { return k < 40 ? 2.0 * random.below(2) - 1 : random.between(-1, 1); };
      const Vec3 p = centre + Vec3(half.x * side(), half.y * side(), half.z * side());
      const FieldSample truth = judge.sample(exactly(p));
      const double value = static_cast<double>(truth.value);
      const double slack = kRounding * (std::abs(value) + length_of(truth.gradient) * (field.reach + p.length()));
      if (!(range.low - slack <= value && value <= range.high + slack)) {
        return fmt::format("at {}: {:.17g} is outside [{:.17g}, {:.17g}]", text(p), value, range.low, range.high);
      }
    }
  }
  return {};
}

std::string box_range_shrinks_with_the_box(const FieldUnderTest& tested, const FieldCase& field) {
  RandomSource random(107);
  for (int i = 0; i < kPoints; ++i) {
    const Vec3 p = interesting_point(random, field);
    const Vec3 half(feature_size(field) * 1e-6);
    const ValueRange range = tested.range_over_box(p - half, p + half);
    const double slack = 1e-3 * (std::abs(tested.value(p)) + unit_of(field));
    if (!(range.high - range.low <= slack)) return fmt::format("at {}: [{}, {}]", text(p), range.low, range.high);
  }
  return {};
}

std::string range_along_a_ray_holds_every_sample(const FieldUnderTest& tested, const FieldCase& field) {
  RandomSource random(109);
  const ReferenceComponent judge = truth_of(field);
  for (int i = 0; i < kPoints; ++i) {
    const ProbeRay ray = probe_ray(random, field);
    const double h = field.reach * std::pow(10, random.between(-3, 0)) / ray.direction.length();
    const double t0 = ray.t - h * random.unit(), t1 = t0 + h;
    const ValueRange range = tested.range_along_ray(ray.origin, ray.direction, t0, t1);
    for (int k = 0; k <= 40; ++k) {
      const long double t = t0 + (static_cast<long double>(t1) - t0) * k / 40;
      const FieldSample truth = judge.sample(exactly(ray.origin) + exactly(ray.direction) * t);
      const double value = static_cast<double>(truth.value);
      const double slack =
          kRounding * (std::abs(value) + length_of(truth.gradient) * (field.reach + ray.origin.length()));
      if (!(range.low - slack <= value && value <= range.high + slack)) {
        return fmt::format("from {} towards {}, t {:.17g} to {:.17g}: {:.17g} is outside [{:.17g}, {:.17g}]",
                           text(ray.origin), text(ray.direction), t0, t1, value, range.low, range.high);
      }
    }
  }
  return {};
}

/// Tests f′ and its change at samples from one end of the stretch to the other.
std::string slope_and_bend_along_a_ray_hold_every_sample(const FieldUnderTest& tested, const FieldCase& field) {
  RandomSource random(110);
  const ReferenceComponent judge = truth_of(field);
  for (int i = 0; i < kPoints; ++i) {
    const ProbeRay ray = probe_ray(random, field);
    const double length = ray.direction.length(), h = field.reach * std::pow(10, random.between(-3, 0)) / length;
    const double t0 = ray.t - h * random.unit(), t1 = t0 + h;
    const ValueRange slopes = tested.slope_range_along_ray(ray.origin, ray.direction, t0, t1);
    const ValueRange bends = tested.bend_range_along_ray(ray.origin, ray.direction, t0, t1);
    const double sensitivity = 1 + 4 * field.reach / feature_size(field);
    double last = 0;
    for (int k = 0; k <= 40; ++k) {
      const long double t = t0 + (static_cast<long double>(t1) - t0) * k / 40;
      const FieldSample truth = judge.sample(exactly(ray.origin) + exactly(ray.direction) * t);
      const double slope = static_cast<double>(dot(truth.gradient, exactly(ray.direction)));
      const double size = (length_of(truth.gradient) + 0.01 * unit_of(field) / feature_size(field)) * length;
      const double slack = kRounding * sensitivity * size;
      if (!(slopes.low - slack <= slope && slope <= slopes.high + slack)) {
        return fmt::format("from {} towards {}, t {:.17g} to {:.17g}: f′ = {:.17g} is outside [{:.17g}, {:.17g}]",
                           text(ray.origin), text(ray.direction), t0, t1, slope, slopes.low, slopes.high);
      }
      const double change = slope - last, step = h / 40;
      if (k > 0 && !(step * bends.low * (bends.low < 0 ? 1 + 1e-9 : 1 - 1e-9) - slack <= change &&
                     change <= step * bends.high * (bends.high > 0 ? 1 + 1e-9 : 1 - 1e-9) + slack)) {
        return fmt::format(
            "from {} towards {}, t {:.17g} to {:.17g}: f′ changes by {:.17g} at sample {}, outside {:.17g} times "
            "[{:.17g}, {:.17g}]",
            text(ray.origin), text(ray.direction), t0, t1, change, k, step, bends.low, bends.high);
      }
      last = slope;
    }
  }
  return {};
}

/// If a stretch is short, the enclosure is as narrow as the change of f′ on it, so that solvers which halve it end.
std::string slope_range_shrinks_with_the_stretch(const FieldUnderTest& tested, const FieldCase& field) {
  RandomSource random(111);
  for (int i = 0; i < kPoints; ++i) {
    const ProbeRay ray = probe_ray(random, field);
    const double length = ray.direction.length(), h = feature_size(field) * 1e-6 / length;
    const ValueRange slopes = tested.slope_range_along_ray(ray.origin, ray.direction, ray.t - h, ray.t + h);
    const Vec3 p = ray.origin + ray.direction * ray.t;
    const double size = (std::abs(tested.value(p)) + unit_of(field)) / feature_size(field) * length;
    if (!(slopes.high - slopes.low <= 1e-3 * size)) {
      return fmt::format("at {} towards {}: [{}, {}]", text(p), text(ray.direction), slopes.low, slopes.high);
    }
  }
  return {};
}

std::string remainder_bounds_the_cubics_error(const FieldUnderTest& tested, const FieldCase& field) {
  RandomSource random(108);
  const ReferenceComponent judge = truth_of(field);
  for (int i = 0; i < kPoints; ++i) {
    const ProbeRay ray = probe_ray(random, field);
    const double length = ray.direction.length();
    const double h = field.reach * std::pow(10, random.between(-3, 0)) / length;
    const double t0 = ray.t - h * random.unit(), t1 = t0 + h;
    const auto exact = [&](double t) {
      const FieldSample s = judge.sample(exactly(ray.origin) + exactly(ray.direction) * static_cast<long double>(t));
      return ValueAndDerivative{static_cast<double>(s.value),
                                static_cast<double>(dot(s.gradient, exactly(ray.direction)))};
    };
    const ValueAndDerivative a = exact(t0), b = exact(t1);
    const RemainderBounds bound = tested.remainder(ray.origin, ray.direction, t0, t1);
    for (int k = 1; k < 40; ++k) {
      const double u = k / 40.0, v = 1 - u;
      const double cubic = v * v * (1 + 2 * u) * a.value + u * u * (3 - 2 * u) * b.value +
                           h * u * v * (v * a.derivative - u * b.derivative);
      const double slope =
          6 * u * v * (b.value - a.value) / h + v * (1 - 3 * u) * a.derivative + u * (3 * u - 2) * b.derivative;
      const ValueAndDerivative here = exact(t0 + h * u);
      // The rounding of the cubic itself and of t, which shifts the sample, is not part of the bound.
      const double noise = 1e-12 * (std::abs(a.value) + std::abs(b.value) + std::abs(here.value) +
                                    (std::abs(a.derivative) + std::abs(b.derivative) + std::abs(here.derivative)) * t1);
      if (!(std::abs(here.value - cubic) <= bound.value * (1 + 1e-9) + noise)) {
        return fmt::format(
            "from {} towards {}, t {:.17g} to {:.17g}: the cubic is off by {} at u = {}, the bound is {}",
            text(ray.origin), text(ray.direction), t0, t1, std::abs(here.value - cubic), u, bound.value);
      }
      const double slope_noise = noise * (10 / h + 10 * length / feature_size(field));
      if (!(std::abs(here.derivative - slope) <= bound.derivative * (1 + 1e-9) + slope_noise)) {
        return fmt::format(
            "from {} towards {}, t {:.17g} to {:.17g}: the slope is off by {} at u = {}, the bound is {}",
            text(ray.origin), text(ray.direction), t0, t1, std::abs(here.derivative - slope), u, bound.derivative);
      }
    }
  }
  return {};
}

}  // namespace

const std::vector<Property>& properties() {
  static const std::vector<Property> list = {
      {"ValueIsTheReferences", value_is_the_references},
      {"GradientIsTheReferences", gradient_is_the_references},
      {"GradientIsTheSlopeOfTheValue", gradient_is_the_slope_of_the_value},
      {"SurfaceAloneIsAtTheRadius", surface_alone_is_at_the_radius},
      {"SlopeAtTheRadiusIsMinusHardness", slope_at_the_radius_is_minus_hardness},
      {"BorderHasNoValueAndNoSlope", border_has_no_value_and_no_slope},
      {"AlongARayIsTheValueAndItsDerivative", along_a_ray_is_the_value_and_its_derivative},
      {"IsSmoothAlongRays", is_smooth_along_rays},
      {"BoxRangeHoldsEverySample", box_range_holds_every_sample},
      {"BoxRangeShrinksWithTheBox", box_range_shrinks_with_the_box},
      {"RangeAlongARayHoldsEverySample", range_along_a_ray_holds_every_sample},
      {"SlopeAndBendAlongARayHoldEverySample", slope_and_bend_along_a_ray_hold_every_sample},
      {"SlopeRangeShrinksWithTheStretch", slope_range_shrinks_with_the_stretch},
      {"RemainderBoundsTheCubicsError", remainder_bounds_the_cubics_error}};
  return list;
}

}  // namespace isl::conformance
