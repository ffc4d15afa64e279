// Functions of vectors. A number in place of a vector fills its three terms.
#include "interpreter/builtins/builtins.h"

#include "interpreter/transforms.h"
#include "renderer/values/integer.h"
#include "renderer/values/noise.h"
#include "renderer/values/single_precision.h"

#include <algorithm>
#include <cmath>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;
using scene::Vec3;

Value normalise(const Arguments& a) {
  const Vec3 v = a.vector(0);
  const double length = std::sqrt(v.dot(v));
  if (length == 0) {
    a.context().warn(a.span(), "a vector of length zero has no direction; it is left unchanged");
    return to_value(v);
  }
  return to_value(v / length);
}

Value rotate_about_axis(const Arguments& a) {
  const Vec3 v = a.vector(0), axis = a.vector(1);
  const double length = std::sqrt(axis.dot(axis));
  if (length == 0) a.context().warn(a.span(), "an axis of length zero has no direction; the result is not a number");
  const Vec3 n = axis / length;
  const double angle = radians_from_degrees(a.number(2)), c = std::cos(angle), s = std::sin(angle);
  // Rodrigues' formula.
  return to_value(v * c + n.cross(v) * s + n * (n.dot(v) * (1 - c)));
}

/// vturbulence(lambda, omega, octaves, p); octaves are truncated to a whole number from 1 to 10. POV-Ray keeps the
/// other two in single precision, which shows in the ninth digit.
Value turbulence(const Arguments& a) {
  constexpr int kMaxOctaves = 10;
  const int count = std::clamp(values::to_integer(a.number(2)), 1, kMaxOctaves);
  const double lambda = values::to_single(a.number(0)), omega = values::to_single(a.number(1));
  return to_value(values::vector_turbulence(a.vector(3), {.lambda = lambda, .omega = omega, .count = count}));
}

const Builtin kVectorFunctions[] = {
    {word::kw_vlength, 1, 1, nullptr,
     [](const Arguments& a) { return Value(std::sqrt(a.vector(0).dot(a.vector(0)))); }},
    {word::kw_vdot, 2, 2, nullptr, [](const Arguments& a) { return Value(a.vector(0).dot(a.vector(1))); }},
    {word::kw_vcross, 2, 2, nullptr, [](const Arguments& a) { return to_value(a.vector(0).cross(a.vector(1))); }},
    {word::kw_vnormalize, 1, 1, nullptr, normalise},
    {word::kw_vrotate, 2, 2, nullptr, [](const Arguments& a) { return to_value(rotated(a.vector(0), a.vector(1))); }},
    {word::kw_vturbulence, 4, 4, nullptr, turbulence},
    {word::kw_vaxis_rotate, 3, 3, nullptr, rotate_about_axis},
};

}  // namespace

std::span<const Builtin> vector_functions() { return kVectorFunctions; }

}  // namespace isl::interpreter
