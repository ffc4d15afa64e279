#include "renderer/values/function_machine.h"

#include "base/check.h"
#include "renderer/values/integer.h"
#include "renderer/values/internal_functions.h"
#include "renderer/values/spline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::values {
namespace {

using scene::Function;
using scene::Instruction;
using scene::Opcode;
using scene::Program;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

/// The three values that `select(a, …)` chooses from stand after a.
double selected(const double* a) { return a[0] < 0 ? a[1] : a[0] == 0 ? a[2] : a[3]; }

/// POV-Ray's weights for the brightness of a colour.
double gray(const double* colour) { return 0.297 * colour[0] + 0.589 * colour[1] + 0.114 * colour[2]; }

/// A height of 16 bits, the upper eight in red and the lower in green; the factor is POV-Ray's, as measured.
double height(const double* colour) { return 0.996093 * (colour[0] + colour[1] / 255); }

void run(const Program& program, double* frame, Environment& environment) noexcept {
  const double* const constants = program.constants.data();
  const auto value = [&](std::uint16_t i) {
    return i < Instruction::kConstants ? frame[i] : constants[i - Instruction::kConstants];
  };
  const std::size_t size = program.code.size();
  for (std::size_t at = 0; at < size; ++at) {
    const Instruction in = program.code[at];
    switch (in.operation) {
      case Opcode::copy: frame[in.to] = value(in.a); break;
      case Opcode::add: frame[in.to] = value(in.a) + value(in.b); break;
      case Opcode::subtract: frame[in.to] = value(in.a) - value(in.b); break;
      case Opcode::multiply: frame[in.to] = value(in.a) * value(in.b); break;
      case Opcode::divide: frame[in.to] = value(in.a) / value(in.b); break;
      case Opcode::call:
        if (!environment.take_step()) return;
        evaluate(*program.callees[in.b], frame + in.a, environment);
        break;
      case Opcode::select: frame[in.to] = selected(frame + in.a); break;
      case Opcode::gray: frame[in.to] = gray(frame + in.a); break;
      case Opcode::height: frame[in.to] = height(frame + in.a); break;
      case Opcode::loop:
        if (!(frame[in.a] <= frame[in.b])) at = std::size_t{in.to} - 1;
        break;
      case Opcode::repeat:
        if (!environment.take_step()) return;
        frame[in.a] += 1;
        at = std::size_t{in.to} - 1;
        break;
      default: frame[in.to] = apply(in.operation, value(in.a), value(in.b)); break;
    }
  }
}

struct Runner {
  double* frame;
  Environment& environment;

  void operator()(const Program& program) const { run(program, frame, environment); }
  void operator()(const scene::InternalFunction& internal) const {
    const InternalFunction& function = internal_functions()[internal.number];
    if (function.takes_scene_noise) frame[3] = static_cast<double>(environment.noise_generator());
    frame[0] = function.evaluate(frame);
  }
  void operator()(const scene::TransformFunction& function) const {
    const scene::Vec3 p = function.transform.point({frame[0], frame[1], frame[2]});
    frame[0] = p.x;
    frame[1] = p.y;
    frame[2] = p.z;
  }
  void operator()(const scene::SplineFunction& function) const {
    const auto terms = evaluate(*function.spline, function.spline->kind, frame[0]);
    std::copy_n(terms.begin(), function.spline->term_count, frame);
  }
  void operator()(const scene::PatternFunction& function) const {
    const scene::Vec3 point(frame[0], frame[1], frame[2]);
    frame[0] = environment.patterns().pattern_value(function.pattern, point, environment);
  }
  void operator()(const scene::PigmentFunction& function) const {
    const scene::Vec3 point(frame[0], frame[1], frame[2]);
    const scene::Colour c = environment.patterns().pigment_colour(function.pigment, point, environment);
    const double terms[] = {c.red, c.green, c.blue, c.filter, c.transmit};
    std::copy_n(terms, 5, frame);
  }
};

/// This is not inlined, so that only the frame that is needed is on the stack.
template <std::size_t size>
[[gnu::noinline]] std::array<double, 5> evaluate_in_frame(const Function& function, std::span<const double> arguments,
                                                          Environment& environment) noexcept {
  double frame[size];
  std::copy(arguments.begin(), arguments.end(), frame);
  evaluate(function, frame, environment);
  std::array<double, 5> results{};
  std::copy_n(frame, std::min<std::size_t>(function.result_count, results.size()), results.begin());
  return results;
}

}  // namespace

double apply(Opcode operation, double a, double b) noexcept {
  switch (operation) {
    case Opcode::add: return a + b;
    case Opcode::subtract: return a - b;
    case Opcode::multiply: return a * b;
    case Opcode::divide: return a / b;
    case Opcode::less: return a < b;
    case Opcode::greater: return a > b;
    case Opcode::equal: return a == b;
    case Opcode::less_equal: return a <= b;
    case Opcode::greater_equal: return a >= b;
    case Opcode::not_equal: return a != b;
    case Opcode::logical_and: return a != 0 && b != 0;
    case Opcode::logical_or: return a != 0 || b != 0;
    case Opcode::minimum: return b < a ? b : a;
    case Opcode::maximum: return b > a ? b : a;
    case Opcode::power: return std::pow(a, b);
    case Opcode::remainder: return std::fmod(a, b);
    case Opcode::quotient: return to_integer(a / b);
    case Opcode::arc_tangent_2: return std::atan2(a, b);
    case Opcode::copy: return a;
    case Opcode::negate: return -a;
    case Opcode::absolute: return std::abs(a);
    case Opcode::floor: return std::floor(a);
    case Opcode::ceiling: return std::ceil(a);
    case Opcode::truncate: return to_integer(a);
    case Opcode::square_root: return std::sqrt(a);
    case Opcode::exponential: return std::exp(a);
    case Opcode::logarithm: return std::log(a);
    case Opcode::logarithm_10: return std::log10(a);
    case Opcode::sine: return std::sin(a);
    case Opcode::cosine: return std::cos(a);
    case Opcode::tangent: return std::tan(a);
    case Opcode::arc_sine: return std::asin(a);
    case Opcode::arc_cosine: return std::acos(a);
    case Opcode::arc_tangent: return std::atan(a);
    case Opcode::hyperbolic_sine: return std::sinh(a);
    case Opcode::hyperbolic_cosine: return std::cosh(a);
    case Opcode::hyperbolic_tangent: return std::tanh(a);
    case Opcode::hyperbolic_arc_sine: return std::asinh(a);
    case Opcode::hyperbolic_arc_cosine: return std::acosh(a);
    case Opcode::hyperbolic_arc_tangent: return std::atanh(a);
    case Opcode::degrees: return a / kRadiansPerDegree;
    case Opcode::radians: return a * kRadiansPerDegree;
    case Opcode::select:
    case Opcode::gray:
    case Opcode::height:
    case Opcode::call:
    case Opcode::loop:
    case Opcode::repeat: break;
  }
  ISL_CHECK(false, "found operation {}, expected one on numbers", static_cast<int>(operation));
}

void evaluate(const scene::Function& function, double* frame, Environment& environment) noexcept {
  std::visit(Runner{frame, environment}, function.body);
}

std::array<double, 5> evaluate(const scene::Function& function, std::span<const double> arguments,
                               Environment& environment) noexcept {
  ISL_DCHECK(arguments.size() == function.parameter_count, "{} of {}", arguments.size(), function.parameter_count);
  // Most functions need a few numbers, and those in patterns are called at every point.
  constexpr std::size_t kUsualFrame = 64;
  return function.frame_size <= kUsualFrame ? evaluate_in_frame<kUsualFrame>(function, arguments, environment)
                                            : evaluate_in_frame<Function::kMaxFrame>(function, arguments, environment);
}

}  // namespace isl::values
