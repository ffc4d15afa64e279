#include "renderer/values/function_machine.h"

#include "renderer/values/internal_functions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace isl::values {
namespace {

using scene::Function;
using scene::Instruction;
using scene::Opcode;
using scene::Program;

constexpr std::uint16_t kFirstConstant = Instruction::kConstants;

double call(const Function& function, std::vector<double> arguments, Environment* given = nullptr) {
  Environment own(NoiseGenerator::range_corrected);
  return evaluate(function, arguments, given ? *given : own)[0];
}

/// a·a + 1
Function square_and_one() {
  Program program;
  program.constants = {1};
  program.code = {{Opcode::multiply, 1, 0, 0}, {Opcode::add, 0, 1, kFirstConstant}};
  Function function;
  function.body = program;
  function.parameter_count = 1;
  function.frame_size = 2;
  return function;
}

/// Σ i, for i from 1 to a
Function sum_to() {
  Program program;
  program.constants = {0, 1};
  program.code = {{Opcode::copy, 1, kFirstConstant, kFirstConstant},
                  {Opcode::copy, 2, kFirstConstant + 1, kFirstConstant + 1},
                  {Opcode::loop, 5, 2, 0},
                  {Opcode::add, 1, 1, 2},
                  {Opcode::repeat, 2, 2, 2},
                  {Opcode::copy, 0, 1, 1}};
  Function function;
  function.body = program;
  function.parameter_count = 1;
  function.frame_size = 3;
  return function;
}

TEST(FunctionMachine, RunsInstructionsInOrder) { EXPECT_EQ(call(square_and_one(), {3}), 10); }

TEST(FunctionMachine, CallsOtherFunctionsInTheirOwnFrame) {
  Program program;
  program.callees = {std::make_shared<Function>(square_and_one())};
  program.code = {{Opcode::copy, 1, 0, 0}, {Opcode::call, 1, 1, 0}, {Opcode::add, 0, 0, 1}};
  Function function;
  function.body = program;
  function.parameter_count = 1;
  function.frame_size = 3;
  EXPECT_EQ(call(function, {3}), 13);
}

TEST(FunctionMachine, LoopsUntilTheEndIsPassed) {
  EXPECT_EQ(call(sum_to(), {4}), 10);
  EXPECT_EQ(call(sum_to(), {4.5}), 10);
  EXPECT_EQ(call(sum_to(), {0}), 0);
  EXPECT_EQ(call(sum_to(), {std::numeric_limits<double>::quiet_NaN()}), 0);
}

TEST(FunctionMachine, StopsWhenItsStepsAreSpent) {
  Environment environment(NoiseGenerator::range_corrected, {.steps_at_point = 100});
  static_cast<void>(call(sum_to(), {std::numeric_limits<double>::infinity()}, &environment));
  EXPECT_TRUE(environment.is_spent());
  Environment enough(NoiseGenerator::range_corrected, {.steps_at_point = 100});
  EXPECT_EQ(call(sum_to(), {50}, &enough), 1275);
  EXPECT_FALSE(enough.is_spent());
}

TEST(FunctionMachine, VectorsTakeThePlaceOfTheArguments) {
  Function function;
  scene::Transform twice;
  for (int i = 0; i < 3; ++i) twice.matrix[i][i] = 2;
  function.body = scene::TransformFunction{twice};
  function.frame_size = function.result_count = 3;
  Environment environment(NoiseGenerator::range_corrected);
  const double point[] = {1, 2, 3};
  const auto moved = evaluate(function, point, environment);
  EXPECT_EQ(moved, (std::array<double, 5>{2, 4, 6, 0, 0}));
}

TEST(InternalFunctions, AreNumberedAsPovraysAre) {
  const auto functions = internal_functions();
  ASSERT_EQ(functions.size(), 79u);
  EXPECT_EQ(functions[0].name, "f_algbr_cyl1");
  EXPECT_EQ(functions[61].name, "f_sphere");
  EXPECT_EQ(functions[78].name, "f_noise_generator");
  EXPECT_FALSE(functions[77].exists());
}

TEST(InternalFunctions, TakeAnyNumberWithoutHarm) {
  constexpr double kExtremes[] = {0, 1e300, -1e300, std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN()};
  for (const InternalFunction& function : internal_functions()) {
    if (!function.evaluate) continue;
    for (const double value : kExtremes) {
      const std::vector<double> p(16, value);
      EXPECT_NO_FATAL_FAILURE(static_cast<void>(function.evaluate(p.data()))) << function.name;
    }
  }
}

}  // namespace
}  // namespace isl::values
