#include "interpreter/arithmetic.h"

#include <algorithm>

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

std::string_view spelling(BinaryOp op) {
  static constexpr std::string_view kSpellings[] = {"+", "-", "*", "/", "<", ">", "=", "<=", ">=", "!=", "&", "|"};
  return kSpellings[static_cast<int>(op)];
}

}  // namespace isl::interpreter
