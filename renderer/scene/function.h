// The content of `function { … }`: a small program over doubles, or one of the bodies that need no program. It is plain
// data that the interpreter compiles once (interpreter/functions/) and renderer/values/function_machine.h evaluates; it
// holds neither text nor names.
//
// Functions call one another by pointer and not by number: most are made by libraries or macros, used for a moment and
// gone, and the database keeps only those that its records refer to.
#pragma once

#include "renderer/scene/spline.h"
#include "renderer/scene/texture.h"
#include "renderer/scene/transform.h"
#include "renderer/scene/value_depth.h"

#include <cstdint>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

namespace isl::scene {

struct Function;
using FunctionPointer = std::shared_ptr<const Function>;

/// The operation of an instruction on the registers `to`, `a`, `b` of the frame.
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
  not_equal,  ///< to = 1 or 0; exact comparison
  logical_and,
  logical_or,  ///< to = 1 or 0; any number but 0 is true
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

/// Register numbers from kConstants on are indices of constants.
struct Instruction {
  static constexpr std::uint16_t kConstants = 0x8000;
  Opcode operation{};
  std::uint16_t to = 0, a = 0, b = 0;
};

/// Runs from the first instruction to the last and leaves the result in register 0. The frame begins with the
/// arguments.
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
  /// 1 for a number, otherwise the number of terms of the vector. The results are at the start of the frame.
  std::uint16_t result_count = 1;
  /// Number of doubles that an evaluation needs, calls included; at most kMaxFrame.
  std::uint32_t frame_size = 0;
  /// Greatest depth of calls, this function included; at most kMaxValueDepth.
  std::uint32_t depth = 1;
  /// Greatest depth of nested patterns and pigments in the function and those that it calls; at most
  /// kMaxValueDepth.
  std::uint32_t pattern_depth = 0;
  /// Names the built-in or pattern in the function, or in one that it calls, that `isl` cannot evaluate: such a
  /// function can be declared, but not evaluated. Empty if there is none. Refers to static text.
  std::string_view missing;

  static constexpr std::uint32_t kMaxFrame = 4096;
};

}  // namespace isl::scene
