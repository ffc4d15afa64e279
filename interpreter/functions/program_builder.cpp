#include "interpreter/functions/program_builder.h"

#include "renderer/values/function_machine.h"

#include <algorithm>
#include <utility>

namespace isl::interpreter {

using scene::Function;
using scene::Instruction;
using scene::Opcode;

namespace {

/// Instructions, constants and callees are numbered in 15 bits.
constexpr std::size_t kMaxNumber = Instruction::kConstants - 1;

}  // namespace

ProgramBuilder::ProgramBuilder(std::size_t parameter_count)
    : parameter_count_(parameter_count),
      top_(static_cast<Operand>(parameter_count)),
      frame_size_(std::max<std::size_t>(parameter_count, 1)) {}

ProgramBuilder::Operand ProgramBuilder::constant(double value) {
  auto& constants = program_.constants;
  if (constants.size() >= kMaxNumber) {
    fits_ = false;
    return Instruction::kConstants;
  }
  constants.push_back(value);
  return static_cast<Operand>(Instruction::kConstants + constants.size() - 1);
}

std::optional<double> ProgramBuilder::constant_value(Operand operand) const {
  // In a program that is too large, the numbers of constants are no longer valid.
  if (operand < Instruction::kConstants || !fits_) return std::nullopt;
  return program_.constants[operand - Instruction::kConstants];
}

ProgramBuilder::Operand ProgramBuilder::take(std::size_t count) {
  const Operand first = top_;
  if (top_ + count > Function::kMaxFrame) {
    fits_ = false;
    return 0;
  }
  top_ = static_cast<Operand>(top_ + count);
  frame_size_ = std::max<std::size_t>(frame_size_, top_);
  return first;
}

void ProgramBuilder::emit(Opcode operation, Operand to, Operand a, Operand b) {
  if (program_.code.size() >= kMaxNumber) {
    fits_ = false;
  } else {
    program_.code.push_back({operation, to, a, b});
  }
}

ProgramBuilder::Operand ProgramBuilder::apply(Opcode operation, Operand a, Operand b, Operand at) {
  const std::optional<double> left = constant_value(a), right = constant_value(b);
  release(at);
  if (left && right) {
    // Constants that only this operation used are the last ones.
    auto& constants = program_.constants;
    const double folded = values::apply(operation, *left, *right);
    while (!constants.empty() && constants.size() > std::min(a, b) - std::size_t{Instruction::kConstants})
      constants.pop_back();
    return constant(folded);
  }
  const Operand to = take();
  emit(operation, to, a, b);
  return to;
}

void ProgramBuilder::move(Operand to, Operand from) {
  if (to != from) emit(Opcode::copy, to, from, from);
}

void ProgramBuilder::call(const scene::FunctionPointer& callee, Operand first) {
  auto& callees = program_.callees;
  const auto known = std::find(callees.begin(), callees.end(), callee);
  const auto number = static_cast<std::size_t>(known - callees.begin());
  if (known == callees.end()) callees.push_back(callee);
  fits_ = fits_ && number < kMaxNumber;
  emit(Opcode::call, first, first, static_cast<Operand>(number));
  frame_size_ = std::max<std::size_t>(frame_size_, first + std::size_t{callee->frame_size});
  depth_ = std::max(depth_, callee->depth + 1);
  pattern_depth_ = std::max(pattern_depth_, callee->pattern_depth);
  if (missing_.empty()) missing_ = callee->missing;
  fits_ = fits_ && frame_size_ <= Function::kMaxFrame;
}

Function ProgramBuilder::finish(Operand result) && {
  move(0, result);
  Function function;
  function.body = std::move(program_);
  function.parameter_count = static_cast<std::uint16_t>(parameter_count_);
  function.frame_size = static_cast<std::uint32_t>(frame_size_);
  function.depth = depth_;
  function.pattern_depth = pattern_depth_;
  function.missing = missing_;
  return function;
}

}  // namespace isl::interpreter
