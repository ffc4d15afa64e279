// What `function { … }` says: a small program over doubles, or one of the bodies that need none. Plain data, made once
// by the interpreter (interpreter/functions/) and evaluated by renderer/values/function_machine.h; knows neither text
// nor names.
//
// Functions call one another by pointer and not by number: most are made by libraries or by macros, used for a moment
// and gone, and the database keeps only those that its records refer to.
#pragma once

#include "renderer/scene/spline.h"
#include "renderer/scene/texture.h"
#include "renderer/scene/transform.h"

#include <cstdint>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

namespace isl::scene {

struct Function;
using FunctionPointer = std::shared_ptr<const Function>;

/// What one instruction does, with its registers `to`, `a`, `b` of the frame.
enum class Opcode : std::uint8_t {
  copy,  ///< to = a
  add,
  subtract,
  multiply,
  divide,  ///< to = a ∘ b
  less,
  greater,
  equal,
  less_equal,
  greater_equal,
  not_equal,  ///< 1 or 0, without slack
  logical_and,
  logical_or,  ///< 1 or 0; any number but 0 is true
  minimum,
  maximum,
  power,
  remainder,
  quotient,
  arc_tangent_2,  ///< to = f(a, b)
  negate,
  absolute,
  floor,
  ceiling,
  truncate,
  square_root,
  exponential,
  logarithm,
  logarithm_10,
  sine,
  cosine,
  tangent,
  arc_sine,
  arc_cosine,
  arc_tangent,
  hyperbolic_sine,
  hyperbolic_cosine,
  hyperbolic_tangent,
  hyperbolic_arc_sine,
  hyperbolic_arc_cosine,
  hyperbolic_arc_tangent,
  degrees,
  radians,  ///< to = f(a)
  select,   ///< to = the register after a for a < 0, the second after it for a = 0, the third for a > 0; NaN takes the
            ///< third
  gray,
  height,  ///< to = the gray value, or the height that image files code in red and green, of a colour from a on
  call,    ///< calls callees[b] with the arguments from register a on; its results take their place
  loop,    ///< while a ≤ b, go on; else go to instruction `to`
  repeat,  ///< a += 1, go to instruction `to`
};

/// Registers from kConstants on are numbers of constants.
struct Instruction {
  static constexpr std::uint16_t kConstants = 0x8000;
  Opcode operation{};
  std::uint16_t to = 0, a = 0, b = 0;
};

/// Runs from the first instruction to the last; the result is then in register 0. The arguments begin the frame.
struct Program {
  std::vector<Instruction> code;
  std::vector<double> constants;
  std::vector<FunctionPointer> callees;
};

/// One of POV-Ray's built-in functions, by its number there (renderer/values/internal_functions.h).
struct InternalFunction {
  std::uint16_t number = 0;
};

/// The three terms of a transformed point.
struct TransformFunction {
  Transform transform;
};

/// The terms of a spline at a parameter.
struct SplineFunction {
  std::shared_ptr<const Spline> spline;
};

/// The five terms of a pigment's colour at a point.
struct PigmentFunction {
  Pigment pigment;
};

/// The value of a pattern at a point.
struct PatternFunction {
  Pattern pattern;
};

struct Function {
  std::variant<Program, InternalFunction, TransformFunction, SplineFunction, PatternFunction, PigmentFunction> body;
  std::uint16_t parameter_count = 3;
  /// 1 for numbers, else the terms of the vector; results begin the frame.
  std::uint16_t result_count = 1;
  /// Doubles that an evaluation takes, calls included; at most kMaxFrame.
  std::uint32_t frame_size = 0;
  /// How many functions call one another at most, this one included; at most kMaxDepth.
  std::uint32_t depth = 1;
  /// How many patterns and pigments stand in one another at most, in what it is or calls; at most kMaxDepth.
  std::uint32_t pattern_depth = 0;
  /// Names what it is, or calls, whose formula is not known here: such a function can be declared, but not evaluated.
  /// Empty for nothing; never owned.
  std::string_view missing;

  static constexpr std::uint32_t kMaxFrame = 4096;
  static constexpr std::uint32_t kMaxDepth = 64;
};

}  // namespace isl::scene
