#include "interpreter/functions/operations.h"

#include <algorithm>
#include <iterator>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;
using grammar::Symbol;
using scene::Operation;

constexpr BuiltinOperation kOperations[] = {
    {word::kw_abs, Operation::absolute, 1},
    {word::kw_acos, Operation::arc_cosine, 1},
    {word::kw_acosh, Operation::hyperbolic_arc_cosine, 1},
    {word::kw_asin, Operation::arc_sine, 1},
    {word::kw_asinh, Operation::hyperbolic_arc_sine, 1},
    {word::kw_atan, Operation::arc_tangent, 1},
    {word::kw_atan2, Operation::arc_tangent_2, 2},
    {word::kw_atanh, Operation::hyperbolic_arc_tangent, 1},
    {word::kw_ceil, Operation::ceiling, 1},
    {word::kw_cos, Operation::cosine, 1},
    {word::kw_cosh, Operation::hyperbolic_cosine, 1},
    {word::kw_degrees, Operation::degrees, 1},
    {word::kw_div, Operation::quotient, 2},
    {word::kw_exp, Operation::exponential, 1},
    {word::kw_floor, Operation::floor, 1},
    {word::kw_int, Operation::truncate, 1},
    {word::kw_ln, Operation::logarithm, 1},
    {word::kw_log, Operation::logarithm_10, 1},
    {word::kw_max, Operation::maximum, 2, true},
    {word::kw_min, Operation::minimum, 2, true},
    {word::kw_mod, Operation::remainder, 2},
    {word::kw_pow, Operation::power, 2},
    {word::kw_radians, Operation::radians, 1},
    {word::kw_sin, Operation::sine, 1},
    {word::kw_sinh, Operation::hyperbolic_sine, 1},
    {word::kw_sqrt, Operation::square_root, 1},
    {word::kw_tan, Operation::tangent, 1},
    {word::kw_tanh, Operation::hyperbolic_tangent, 1},
};

struct NamedItem {
  Symbol name;
  ResultItem item;
};

constexpr NamedItem kItems[] = {
    {word::kw_x, {Operation::copy, 0}},        {word::kw_u, {Operation::copy, 0}},
    {word::kw_red, {Operation::copy, 0}},      {word::kw_y, {Operation::copy, 1}},
    {word::kw_v, {Operation::copy, 1}},        {word::kw_green, {Operation::copy, 1}},
    {word::kw_z, {Operation::copy, 2}},        {word::kw_blue, {Operation::copy, 2}},
    {word::kw_t, {Operation::copy, 3}},        {word::kw_filter, {Operation::copy, 3}},
    {word::kw_transmit, {Operation::copy, 4}}, {word::kw_gray, {Operation::gray, 2}},
};

}  // namespace

Operation operation_of(grammar::BinaryOp op) {
  // In the order of grammar::BinaryOp.
  static constexpr Operation kBinary[] = {Operation::add,       Operation::subtract,    Operation::multiply,
                                          Operation::divide,    Operation::less,        Operation::greater,
                                          Operation::equal,     Operation::less_equal,  Operation::greater_equal,
                                          Operation::not_equal, Operation::logical_and, Operation::logical_or};
  return kBinary[static_cast<std::size_t>(op)];
}

const BuiltinOperation* builtin_operation(Symbol name) {
  const auto at = std::ranges::find(kOperations, name, &BuiltinOperation::name);
  return at == std::end(kOperations) ? nullptr : at;
}

std::optional<ResultItem> result_item(Symbol name) {
  const auto at = std::ranges::find(kItems, name, &NamedItem::name);
  if (at == std::end(kItems)) return std::nullopt;
  return at->item;
}

}  // namespace isl::interpreter
