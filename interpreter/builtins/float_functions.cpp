// Functions of numbers. Values outside a function's domain are errors where POV-Ray reports errors, and warnings where
// it warns.
#include "interpreter/builtins/builtins.h"
#include "interpreter/builtins/rounding.h"
#include "interpreter/expressions.h"
#include "renderer/values/integer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

/// acos and asin outside [−1, 1] give the nearest value, with a warning, as in POV-Ray.
double clamped(const Arguments& a) {
  const double value = a.number(0);
  if (std::abs(value) <= 1) return value;
  a.context().warn(a.span(), fmt::format("expected a number from -1 to 1, found {:g}; the nearest is used", value));
  return std::clamp(value, -1.0, 1.0);
}

double positive(const Arguments& a) {
  const double value = a.number(0);
  if (!(value > 0)) a.fail(0, fmt::format("expected a number above 0, found {:g}", value));
  return value;
}

/// A divisor of zero: fmod and the quotient follow C, with a warning.
double divisor(const Arguments& a) {
  const double value = a.number(1);
  if (value == 0) a.context().warn(a.span(), "division by zero");
  return value;
}

Value square_root(const Arguments& a) {
  const double square = a.number(0);
  if (!(square < 0)) return Value(std::sqrt(square));
  const grammar::Node* const expression = a.expression(0);
  if (expression == nullptr || !is_negative_by_rounding(a.context(), *expression, square))
    a.fail(0, fmt::format("expected a number that is not negative, found {:g}", square));
  a.context().warn(a.span(0),
                   fmt::format("the square root of {:g}, negative by rounding alone, is taken as 0", square));
  return Value(0.0);
}

/// 0⁰ is an error; any other power that is not a number is a warning.
Value power(const Arguments& a) {
  if (a.number(0) == 0 && a.number(1) == 0) a.fail(0, "0 to the power of 0 has no value");
  const double result = std::pow(a.number(0), a.number(1));
  if (std::isnan(result)) {
    a.context().warn(a.span(), fmt::format("{:g} to the power of {:g} is not a real number", a.number(0), a.number(1)));
  }
  return Value(result);
}

Value arc_tangent(const Arguments& a) {
  const double y = a.number(0), x = a.number(1);
  if (std::abs(y) < kTolerance && std::abs(x) < kTolerance) a.fail(0, "both arguments are 0, which gives no angle");
  return Value(std::atan2(y, x));
}

/// Converts through a 32-bit integer, as POV-Ray does.
double integer(const Arguments& a, double value) {
  const std::int32_t result = values::to_integer(value);
  if (std::abs(value - result) >= 1) a.context().warn(a.span(), fmt::format("{:g} does not fit into 32 bits", value));
  return result;
}

template <class Better>
Value best(const Arguments& a, Better better) {
  double result = a.number(0);
  for (std::size_t i = 1; i < a.size(); ++i) {
    if (better(a.number(i), result)) result = a.number(i);
  }
  return Value(result);
}

/// select(a, negative, zero or more), select(a, negative, zero, positive): a is a number, the results may be any
/// values.
Value select(const Arguments& a) {
  const double decider = a.number(0);
  if (decider < 0) return a[1];
  if (a.size() == 3 || decider == 0) return a[2];
  return a[3];
}

template <class Operation>
Value bitwise(const Arguments& a, Operation operation) {
  std::int32_t result = values::to_integer(a.number(0));
  for (std::size_t i = 1; i < a.size(); ++i) result = operation(result, values::to_integer(a.number(i)));
  return Value(static_cast<double>(result));
}

Value next_random(const Arguments& a) {
  const std::optional<double> number = a.context().random.next(a.number(0));
  if (!number) a.fail(0, fmt::format("there is no random stream {:g}; `seed(number)` makes one", a.number(0)));
  return Value(*number);
}

Value open_random(const Arguments& a) {
  a.context().check_memory(a.span(), sizeof(std::uint32_t));
  a.context().memory.add(sizeof(std::uint32_t));
  return Value(a.context().random.open(values::to_integer(a.number(0))));
}

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

const Builtin kFloatFunctions[] = {
    {word::kw_abs, 1, 1, [](double v) { return std::abs(v); }},
    {word::kw_acosh, 1, 1, [](double v) { return std::acosh(v); }},
    {word::kw_asinh, 1, 1, [](double v) { return std::asinh(v); }},
    {word::kw_atan, 1, 1, [](double v) { return std::atan(v); }},
    {word::kw_atanh, 1, 1, [](double v) { return std::atanh(v); }},
    {word::kw_ceil, 1, 1, [](double v) { return std::ceil(v); }},
    {word::kw_cos, 1, 1, [](double v) { return std::cos(v); }},
    {word::kw_cosh, 1, 1, [](double v) { return std::cosh(v); }},
    {word::kw_degrees, 1, 1, [](double v) { return v / kRadiansPerDegree; }},
    {word::kw_exp, 1, 1, [](double v) { return std::exp(v); }},
    {word::kw_floor, 1, 1, [](double v) { return std::floor(v); }},
    {word::kw_int, 1, 1, nullptr, [](const Arguments& a) { return Value(integer(a, a.number(0))); }},
    {word::kw_radians, 1, 1, [](double v) { return v * kRadiansPerDegree; }},
    {word::kw_sin, 1, 1, [](double v) { return std::sin(v); }},
    {word::kw_sinh, 1, 1, [](double v) { return std::sinh(v); }},
    {word::kw_tan, 1, 1, [](double v) { return std::tan(v); }},
    {word::kw_tanh, 1, 1, [](double v) { return std::tanh(v); }},
    {word::kw_acos, 1, 1, nullptr, [](const Arguments& a) { return Value(std::acos(clamped(a))); }},
    {word::kw_asin, 1, 1, nullptr, [](const Arguments& a) { return Value(std::asin(clamped(a))); }},
    {word::kw_atan2, 2, 2, nullptr, arc_tangent},
    {word::kw_div, 2, 2, nullptr, [](const Arguments& a) { return Value(integer(a, a.number(0) / divisor(a))); }},
    {word::kw_mod, 2, 2, nullptr, [](const Arguments& a) { return Value(std::fmod(a.number(0), divisor(a))); }},
    {word::kw_ln, 1, 1, nullptr, [](const Arguments& a) { return Value(std::log(positive(a))); }},
    {word::kw_log, 1, 1, nullptr, [](const Arguments& a) { return Value(std::log10(positive(a))); }},
    {word::kw_sqrt, 1, 1, nullptr, square_root},
    {word::kw_pow, 2, 2, nullptr, power},
    {word::kw_max, 1, Builtin::kAnyNumber, nullptr, [](const Arguments& a) { return best(a, std::greater<>()); }},
    {word::kw_min, 1, Builtin::kAnyNumber, nullptr, [](const Arguments& a) { return best(a, std::less<>()); }},
    {word::kw_select, 3, 4, nullptr, select},
    {word::kw_bitwise_and, 1, Builtin::kAnyNumber, nullptr,
     [](const Arguments& a) { return bitwise(a, std::bit_and<>()); }},
    {word::kw_bitwise_or, 1, Builtin::kAnyNumber, nullptr,
     [](const Arguments& a) { return bitwise(a, std::bit_or<>()); }},
    {word::kw_bitwise_xor, 1, Builtin::kAnyNumber, nullptr,
     [](const Arguments& a) { return bitwise(a, std::bit_xor<>()); }},
    {word::kw_rand, 1, 1, nullptr, next_random},
    {word::kw_seed, 1, 1, nullptr, open_random},
};

}  // namespace

std::span<const Builtin> float_functions() { return kFloatFunctions; }

}  // namespace isl::interpreter
