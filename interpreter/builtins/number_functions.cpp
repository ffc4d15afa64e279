#include "interpreter/builtins/number_functions.h"

#include "interpreter/arithmetic.h"
#include "interpreter/builtins/builtins.h"
#include "renderer/values/integer.h"

#include <array>
#include <cmath>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

bool whole(double value, double& result) {
  result = values::to_integer(value);
  return std::abs(value - result) < 1;
}

struct Row {
  grammar::Symbol name;
  std::size_t arguments;
  NumberFunction::Apply apply;
};

constexpr Row kRows[] = {
    {word::kw_int, 1, [](double a, double, double& result) { return whole(a, result); }},
    {word::kw_div, 2, [](double a, double b, double& result) { return b != 0 && whole(a / b, result); }},
    {word::kw_mod, 2,
     [](double a, double b, double& result) {
       result = std::fmod(a, b);
       return b != 0;
     }},
    {word::kw_sqrt, 1,
     [](double a, double, double& result) {
       result = std::sqrt(a);
       return !(a < 0);
     }},
    {word::kw_pow, 2,
     [](double a, double b, double& result) {
       result = std::pow(a, b);
       return (a != 0 || b != 0) && !std::isnan(result);
     }},
    {word::kw_max, 2,
     [](double a, double b, double& result) {
       result = b > a ? b : a;
       return true;
     }},
    {word::kw_min, 2,
     [](double a, double b, double& result) {
       result = b < a ? b : a;
       return true;
     }},
    {word::kw_atan2, 2,
     [](double a, double b, double& result) {
       result = std::atan2(a, b);
       return std::abs(a) >= kTolerance || std::abs(b) >= kTolerance;
     }},
    {word::kw_ln, 1,
     [](double a, double, double& result) {
       result = std::log(a);
       return a > 0;
     }},
};

std::array<NumberFunction, word::kReservedCount> functions_by_word() {
  std::array<NumberFunction, word::kReservedCount> table{};
  for (const Builtin& function : float_functions()) {
    if (function.of_number) table[static_cast<std::uint32_t>(function.name)] = {1, function.of_number, nullptr};
  }
  for (const Row& row : kRows) table[static_cast<std::uint32_t>(row.name)] = {row.arguments, nullptr, row.apply};
  return table;
}

}  // namespace

const NumberFunction* number_function(grammar::Symbol name) {
  if (!grammar::is_reserved(name)) return nullptr;
  static const auto kTable = functions_by_word();
  const NumberFunction& function = kTable[static_cast<std::uint32_t>(name)];
  return function.arguments > 0 ? &function : nullptr;
}

}  // namespace isl::interpreter
