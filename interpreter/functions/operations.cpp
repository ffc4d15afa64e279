#include "interpreter/functions/operations.h"

#include <algorithm>
#include <iterator>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;
using grammar::Symbol;
using scene::Opcode;

constexpr BuiltinOperation kOperations[] = {
    {word::kw_abs, Opcode::absolute, 1},
    {word::kw_acos, Opcode::arc_cosine, 1},
    {word::kw_acosh, Opcode::hyperbolic_arc_cosine, 1},
    {word::kw_asin, Opcode::arc_sine, 1},
    {word::kw_asinh, Opcode::hyperbolic_arc_sine, 1},
    {word::kw_atan, Opcode::arc_tangent, 1},
    {word::kw_atan2, Opcode::arc_tangent_2, 2},
    {word::kw_atanh, Opcode::hyperbolic_arc_tangent, 1},
    {word::kw_ceil, Opcode::ceiling, 1},
    {word::kw_cos, Opcode::cosine, 1},
    {word::kw_cosh, Opcode::hyperbolic_cosine, 1},
    {word::kw_degrees, Opcode::degrees, 1},
    {word::kw_div, Opcode::quotient, 2},
    {word::kw_exp, Opcode::exponential, 1},
    {word::kw_floor, Opcode::floor, 1},
    {word::kw_int, Opcode::truncate, 1},
    {word::kw_ln, Opcode::logarithm, 1},
    {word::kw_log, Opcode::logarithm_10, 1},
    {word::kw_max, Opcode::maximum, 2, true},
    {word::kw_min, Opcode::minimum, 2, true},
    {word::kw_mod, Opcode::remainder, 2},
    {word::kw_pow, Opcode::power, 2},
    {word::kw_radians, Opcode::radians, 1},
    {word::kw_sin, Opcode::sine, 1},
    {word::kw_sinh, Opcode::hyperbolic_sine, 1},
    {word::kw_sqrt, Opcode::square_root, 1},
    {word::kw_tan, Opcode::tangent, 1},
    {word::kw_tanh, Opcode::hyperbolic_tangent, 1},
};

struct NamedItem {
  Symbol name;
  ResultItem item;
};

constexpr NamedItem kItems[] = {
    {word::kw_x, {Opcode::copy, 0}},      {word::kw_u, {Opcode::copy, 0}},        {word::kw_red, {Opcode::copy, 0}},
    {word::kw_y, {Opcode::copy, 1}},      {word::kw_v, {Opcode::copy, 1}},        {word::kw_green, {Opcode::copy, 1}},
    {word::kw_z, {Opcode::copy, 2}},      {word::kw_blue, {Opcode::copy, 2}},     {word::kw_t, {Opcode::copy, 3}},
    {word::kw_filter, {Opcode::copy, 3}}, {word::kw_transmit, {Opcode::copy, 4}}, {word::kw_gray, {Opcode::gray, 2}},
};

}  // namespace

Opcode operation_of(grammar::BinaryOp op) {
  // In the order of grammar::BinaryOp.
  static constexpr Opcode kBinary[] = {Opcode::add,       Opcode::subtract,    Opcode::multiply,
                                       Opcode::divide,    Opcode::less,        Opcode::greater,
                                       Opcode::equal,     Opcode::less_equal,  Opcode::greater_equal,
                                       Opcode::not_equal, Opcode::logical_and, Opcode::logical_or};
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
