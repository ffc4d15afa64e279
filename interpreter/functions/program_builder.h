// Puts a scene::Program together: registers are handed out like a stack, constants are folded. The compiler
// (interpreter/functions/compiler.h) says what to compute; this file knows nothing of the language.
#pragma once

#include "renderer/scene/function.h"

#include <optional>
#include <string_view>
#include <vector>

namespace isl::interpreter {

class ProgramBuilder {
 public:
  /// The place of a value: a register, or a constant from scene::Instruction::kConstants on.
  using Operand = std::uint16_t;

  explicit ProgramBuilder(std::size_t parameter_count);

  [[nodiscard]] Operand constant(double value);
  /// The value of a constant; none for a register.
  [[nodiscard]] std::optional<double> constant_value(Operand operand) const;

  /// The first free register. The caller that is done with the registers above it frees them with release().
  [[nodiscard]] Operand top() const { return top_; }
  void release(Operand top) { top_ = top; }
  [[nodiscard]] Operand take(std::size_t count = 1);

  /// The operation's result in a new register at `at` (where the operands' temporaries began); folded if both are
  /// known.
  [[nodiscard]] Operand apply(scene::Opcode operation, Operand a, Operand b, Operand at);
  /// Makes sure that the value is in that register.
  void move(Operand to, Operand from);
  void emit(scene::Opcode operation, Operand to, Operand a, Operand b);
  /// Calls `callee` with the arguments from register `first` on.
  void call(const scene::FunctionPointer& callee, Operand first);

  /// The number of the next instruction, for loops.
  [[nodiscard]] Operand position() const { return static_cast<Operand>(program_.code.size()); }
  void set_target(Operand instruction, Operand target) { program_.code[instruction].to = target; }

  /// False when the program has become larger than the machine can take; then it must not be finished.
  [[nodiscard]] bool fits() const { return fits_; }
  /// The depth of calls so far; a program deeper than values may be must not be finished either.
  [[nodiscard]] std::uint32_t depth() const { return depth_; }
  [[nodiscard]] scene::Function finish(Operand result) &&;

 private:
  scene::Program program_;
  std::size_t parameter_count_;
  Operand top_;
  std::size_t frame_size_;
  std::uint32_t depth_ = 1;
  std::uint32_t pattern_depth_ = 0;
  std::string_view missing_;
  bool fits_ = true;
};

}  // namespace isl::interpreter
