#include "interpreter/arithmetic.h"

#include <algorithm>
#include <functional>

namespace isl::interpreter {

using grammar::BinaryOp;

namespace {

template <class Operation>
Value componentwise(const Operand& a, const Operand& b, Operation operation) {
  const int count = std::max(a.count, b.count), a_stride = a.stride(), b_stride = b.stride();
  const double *p = a.terms, *q = b.terms;
  Value::Terms terms{};
  for (int i = 0; i < count; ++i, p += a_stride, q += b_stride) terms[i] = operation(*p, *q);
  return {count, terms};
}

}  // namespace

Value arithmetic(BinaryOp op, const Operand& a, const Operand& b) {
  switch (op) {
    case BinaryOp::add: return componentwise(a, b, std::plus<>());
    case BinaryOp::subtract: return componentwise(a, b, std::minus<>());
    case BinaryOp::multiply: return componentwise(a, b, std::multiplies<>());
    case BinaryOp::divide: return componentwise(a, b, quotient);
    default: ISL_CHECK(false, "`{}` is no arithmetic", spelling(op));
  }
}

std::string_view spelling(BinaryOp op) {
  static constexpr std::string_view kSpellings[] = {"+", "-", "*", "/", "<", ">", "=", "<=", ">=", "!=", "&", "|"};
  return kSpellings[static_cast<int>(op)];
}

}  // namespace isl::interpreter
