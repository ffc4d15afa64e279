#include "interpreter/builtins/rounding.h"

#include "interpreter/expressions.h"

#include <algorithm>
#include <cmath>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::BinaryOp;
using grammar::Node;
using grammar::NodeKind;
namespace word = grammar::word;

/// True if evaluating the expression once more changes nothing.
bool is_repeatable(const Node& node) {
  switch (node.kind) {
    case NodeKind::number:
    case NodeKind::constant:
    case NodeKind::name: return true;
    case NodeKind::dot: return is_repeatable(*as<grammar::Dot>(node).base);
    case NodeKind::unary: return is_repeatable(*as<grammar::Unary>(node).operand);
    case NodeKind::index:
      return is_repeatable(*as<grammar::Index>(node).base) && is_repeatable(*as<grammar::Index>(node).subscript);
    case NodeKind::binary:
      return is_repeatable(*as<grammar::Binary>(node).left) && is_repeatable(*as<grammar::Binary>(node).right);
    case NodeKind::function_call: {
      const auto& call = as<grammar::FunctionCall>(node);
      if (call.function == word::kw_rand || call.function == word::kw_seed || call.function == word::kw_trace)
        return false;
      return std::ranges::all_of(call.arguments, [](const grammar::Argument& argument) {
        return argument.size() == 1 && is_repeatable(*argument[0]);
      });
    }
    default: return false;
  }
}

/// The sum of the absolute values of the terms of a repeatable expression, with products multiplied out.
double sum_of_terms(Context& context, const Node& node) {
  if (node.kind == NodeKind::unary) return sum_of_terms(context, *as<grammar::Unary>(node).operand);
  if (node.kind == NodeKind::binary) {
    const auto& binary = as<grammar::Binary>(node);
    const double left = sum_of_terms(context, *binary.left);
    if (binary.op == BinaryOp::divide) return left / std::abs(evaluate_number(context, *binary.right));
    const double right = sum_of_terms(context, *binary.right);
    return binary.op == BinaryOp::multiply ? left * right : left + right;
  }
  return std::abs(evaluate_number(context, node));
}

}  // namespace

bool is_negative_by_rounding(Context& context, const Node& expression, double value) {
  return value < 0 && is_repeatable(expression) && -value <= 0x1p-40 * sum_of_terms(context, expression);
}

}  // namespace isl::interpreter
