// Operators on numeric values. The shorter operand is promoted as POV-Ray does: a number fills all terms, a vector is
// padded with zeros. Pure functions; the caller reports errors.
#pragma once

#include "base/check.h"
#include "grammar/ast.h"
#include "interpreter/value.h"

#include <cmath>
#include <limits>

namespace isl::interpreter {

/// `value` with at least `count` terms: a number fills all of them, a vector is padded with zeros. A longer one stays.
[[nodiscard]] inline Value promoted(const Value& value, int count) {
  if (value.term_count() >= count) return value;
  if (!value.is_number()) return {count, value.terms()};
  Value::Terms terms{};
  for (int i = 0; i < count; ++i) terms[i] = value.number();
  return {count, terms};
}

/// The terms of a number (count 1) or of a vector, which has five in memory: those past its count are zero.
struct Operand {
  const double* terms;
  int count;

  [[nodiscard]] double operator[](int i) const { return terms[count == 1 ? 0 : i]; }
  [[nodiscard]] int stride() const { return count == 1 ? 0 : 1; }
};

/// a / b; positive infinity if b is zero, for any a (POV-Ray's rule; the caller warns).
[[nodiscard]] inline double quotient(double a, double b) {
  return b == 0 ? std::numeric_limits<double>::infinity() : a / b;
}

/// a op b for + − * /, componentwise.
[[nodiscard]] Value arithmetic(grammar::BinaryOp op, const Operand& a, const Operand& b);

/// POV-Ray's tolerance in `=`, `!=`, `<=`, `>=`, in conditions, and in loops.
inline constexpr double kTolerance = 1e-10;

/// Comparison and logic of two numbers, 0 or 1.
[[nodiscard]] inline double compare(grammar::BinaryOp op, double a, double b) {
  using enum grammar::BinaryOp;
  switch (op) {
    case less: return a < b;
    case greater: return a > b;
    case equal: return a == b || std::abs(a - b) < kTolerance;
    case less_equal: return a <= b + kTolerance;
    case greater_equal: return a >= b - kTolerance;
    case not_equal: return !(a == b || std::abs(a - b) < kTolerance);
    case logical_and: return std::abs(a) > kTolerance && std::abs(b) > kTolerance;
    case logical_or: return std::abs(a) > kTolerance || std::abs(b) > kTolerance;
    default: ISL_CHECK(false, "operator {} is no comparison", static_cast<int>(op));
  }
}

[[nodiscard]] inline double applied(grammar::UnaryOp op, double operand) {
  switch (op) {
    case grammar::UnaryOp::plus: return operand;
    case grammar::UnaryOp::minus: return -operand;
    case grammar::UnaryOp::logical_not: return std::abs(operand) <= kTolerance ? 1 : 0;
  }
  ISL_CHECK(false, "operator {}", static_cast<int>(op));
}

/// The operator's spelling in a scene.
[[nodiscard]] std::string_view spelling(grammar::BinaryOp op);

}  // namespace isl::interpreter
