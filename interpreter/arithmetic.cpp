#include "interpreter/arithmetic.h"

#include "interpreter/expressions.h"

#include <algorithm>
#include <cmath>

namespace isl::interpreter {

using grammar::BinaryOp;

Value arithmetic(BinaryOp op, const Operand& a, const Operand& b) {
  const int count = std::max(a.count, b.count);
  Value::Terms terms{};
  switch (op) {
    case BinaryOp::add:
      for (int i = 0; i < count; ++i) terms[i] = a[i] + b[i];
      break;
    case BinaryOp::subtract:
      for (int i = 0; i < count; ++i) terms[i] = a[i] - b[i];
      break;
    case BinaryOp::multiply:
      for (int i = 0; i < count; ++i) terms[i] = a[i] * b[i];
      break;
    case BinaryOp::divide:
      for (int i = 0; i < count; ++i) terms[i] = quotient(a[i], b[i]);
      break;
    default: ISL_CHECK(false, "`{}` is no arithmetic", spelling(op));
  }
  return {count, terms};
}

double compare(BinaryOp op, double a, double b) {
  switch (op) {
    case BinaryOp::less: return a < b;
    case BinaryOp::greater: return a > b;
    case BinaryOp::equal: return a == b || std::abs(a - b) < kTolerance;
    case BinaryOp::less_equal: return a <= b + kTolerance;
    case BinaryOp::greater_equal: return a >= b - kTolerance;
    case BinaryOp::not_equal: return !(a == b || std::abs(a - b) < kTolerance);
    case BinaryOp::logical_and: return std::abs(a) > kTolerance && std::abs(b) > kTolerance;
    case BinaryOp::logical_or: return std::abs(a) > kTolerance || std::abs(b) > kTolerance;
    default: ISL_CHECK(false, "`{}` is no comparison", spelling(op));
  }
}

std::string_view spelling(BinaryOp op) {
  static constexpr std::string_view kSpellings[] = {"+", "-", "*", "/", "<", ">", "=", "<=", ">=", "!=", "&", "|"};
  return kSpellings[static_cast<int>(op)];
}

}  // namespace isl::interpreter
