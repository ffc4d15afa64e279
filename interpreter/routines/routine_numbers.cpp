#include "interpreter/operators.h"
#include "interpreter/routines/building.h"

#include <numbers>
#include <utility>

namespace isl::interpreter {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;
namespace op = operations;
namespace word = grammar::word;

void RoutineBuilder::add_number_in(const Node& node, std::uint32_t to) {
  const Index begin = here();
  if (number_in(node, to)) {
    detours_.push_back({begin, here(), {op::evaluate_number(), &node, 0, 0, to, 0}});
  } else {
    take_back(begin);
    land(add(op::evaluate_number(), node, to));
  }
}

bool RoutineBuilder::number_in(const Node& node, std::uint32_t to) {
  const std::uint32_t registers = std::exchange(registers_, to);
  const std::optional<NumberPlace> value = number(node);
  registers_ = registers;
  if (!value) return false;
  if (value->source != Source::register_ || value->index != to) add(op::load(value->source), value->index, 0, to);
  return true;
}

NumberPlace RoutineBuilder::constant(double value) {
  routine_.constants.push_back(value);
  return {Source::constant, static_cast<std::uint32_t>(routine_.constants.size() - 1)};
}

const grammar::Name* RoutineBuilder::name_of_list(const Node& target) {
  if (target.kind != NodeKind::index) return nullptr;
  const Node& base = *as<grammar::Index>(target).base;
  return base.kind == NodeKind::name ? &as<grammar::Name>(base) : nullptr;
}

std::optional<NumberPlace> RoutineBuilder::number(const Node& node) {
  const std::uint32_t to = registers_;
  if (!has_register()) return {};
  switch (node.kind) {
    case NodeKind::number: return constant(as<grammar::Number>(node).value);
    case NodeKind::name: return NumberPlace{Source::name, symbol(as<grammar::Name>(node).name)};
    case NodeKind::constant: return number_of_constant(as<grammar::Constant>(node));
    case NodeKind::binary: return number_of_binary(as<grammar::Binary>(node));
    case NodeKind::conditional: return number_of_conditional(as<grammar::Conditional>(node));
    case NodeKind::function_call: return number_of_call(as<grammar::FunctionCall>(node));
    case NodeKind::dot: {
      const auto& dot = as<grammar::Dot>(node);
      const int term = term_of_item(dot.item);
      if (dot.base->kind != NodeKind::name || term < 0) return {};
      add(op::item(), symbol(as<grammar::Name>(*dot.base).name), static_cast<std::uint32_t>(term), to);
      return NumberPlace{Source::register_, to};
    }
    case NodeKind::index: {
      const grammar::Name* const list = name_of_list(node);
      const std::optional<NumberPlace> index = list ? number(*as<grammar::Index>(node).subscript) : std::nullopt;
      if (!index) return {};
      add(op::element(index->source), index->index, symbol(list->name), to);
      return NumberPlace{Source::register_, to};
    }
    case NodeKind::unary: {
      const auto& unary = as<grammar::Unary>(node);
      if (unary.negative) return constant(*unary.negative);
      const std::optional<NumberPlace> operand = number(*unary.operand);
      if (!operand) return {};
      add(op::unary(unary.op, operand->source), operand->index, 0, to);
      return NumberPlace{Source::register_, to};
    }
    default: return {};
  }
}

std::optional<NumberPlace> RoutineBuilder::number_of_constant(const grammar::Constant& node) {
  switch (static_cast<word::Index>(node.word)) {
    case word::kIndex_pi: return constant(std::numbers::pi);
    case word::kIndex_yes:
    case word::kIndex_on:
    case word::kIndex_true: return constant(1);
    case word::kIndex_no:
    case word::kIndex_off:
    case word::kIndex_false: return constant(0);
    default: return {};
  }
}

std::optional<NumberPlace> RoutineBuilder::number_of_binary(const grammar::Binary& node) {
  const std::uint32_t to = registers_;
  // With a literal it is a comparison of strings, or a mistake.
  if (node.left->kind == NodeKind::string || node.right->kind == NodeKind::string) {
    add(op::compare_texts(), node, to);
    return NumberPlace{Source::register_, to};
  }
  const std::optional<NumberPlace> left = number(*node.left);
  if (!left) return {};
  // The right side must leave the left one's register alone.
  if (left->source == Source::register_) ++registers_;
  const std::optional<NumberPlace> right = number(*node.right);
  registers_ = to;
  if (!right) return {};
  add(op::binary(node.op, left->source, right->source), left->index, right->index, to);
  last_operator_ = {here() - 1, node.op, left->source, right->source};
  return NumberPlace{Source::register_, to};
}

std::optional<NumberPlace> RoutineBuilder::number_of_conditional(const grammar::Conditional& node) {
  const std::uint32_t to = registers_;
  if (to + 3 > Machine::kRegisters) return {};
  if (!number_in(*node.condition, to)) return {};
  registers_ = to + 1;
  const bool has_yes = number_in(*node.yes, to + 1);
  registers_ = to + 2;
  const bool has_both = has_yes && number_in(*node.no, to + 2);
  registers_ = to;
  if (!has_both) return {};
  add(op::choose(), to + 1, to + 2, to);
  return NumberPlace{Source::register_, to};
}

std::optional<NumberPlace> RoutineBuilder::number_of_call(const grammar::FunctionCall& node) {
  const NumberFunction* const function = number_function(node.function);
  const std::uint32_t to = registers_;
  if (!function || node.arguments.size() != function->arguments) return {};
  if (to + node.arguments.size() > Machine::kRegisters) return {};
  for (const grammar::Argument& argument : node.arguments) {
    const bool is_plain = argument.size() == 1 && number_in(*argument[0], registers_);
    if (!is_plain) {
      registers_ = to;
      return {};
    }
    ++registers_;
  }
  registers_ = to;
  const Index at = add(op::call(), to, 0, to);
  routine_.operations[at].function = function;
  return NumberPlace{Source::register_, to};
}

}  // namespace isl::interpreter
