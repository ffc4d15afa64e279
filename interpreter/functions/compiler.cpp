#include "interpreter/functions/compiler.h"

#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/functions/operations.h"
#include "interpreter/functions/program_builder.h"
#include "interpreter/newer_words.h"
#include "interpreter/places.h"
#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;
using grammar::Symbol;
using scene::Opcode;
namespace word = grammar::word;

class Compiler {
  using Operand = ProgramBuilder::Operand;

 public:
  Compiler(Context& context, std::span<const Symbol> parameters, SourceSpan span)
      : context_(context), parameters_(parameters), span_(span), builder_(parameters.size()) {}

  scene::Function compile_body(grammar::Items body) {
    ElementStream stream(context_, body, span_);
    const Operand result = compile_stream(stream, "an expression");
    check_size();
    return std::move(builder_).finish(result);
  }

 private:
  struct Local {
    Symbol name;
    Operand place;
  };

  void check_size() const {
    context_.check_value_depth(span_, builder_.depth());
    if (builder_.fits()) return;
    context_.fail(span_, fmt::format("this function is too large: it may have {} intermediate values",
                                     scene::Function::kMaxFrame));
  }

  // ---- Items --------------------------------------------------------------------------------------------------------

  /// Compiles one expression, of one element or of several that directives and macros yield: `0 #for (I, 1, 3) + I*x
  /// #end`.
  Operand compile_stream(ElementStream& stream, std::string_view what) {
    const Operand at = builder_.top();
    Operand sum = compile_element(stream, what);
    while (!stream.peek().is(ElementKind::end)) {
      const Element next = stream.peek();
      if (!next.is(ElementKind::value) || !begins_with_sign(*next.node)) fail_expected(stream, "an operator");
      const Operand term = compile_element(stream, what);
      sum = builder_.apply(Opcode::add, sum, term, at);
    }
    return sum;
  }

  Operand compile_element(ElementStream& stream, std::string_view what) {
    const Element element = stream.peek();
    if (!element.is(ElementKind::value) && !(element.is(ElementKind::unknown) && element.node))
      fail_expected(stream, what);
    stream.drop();
    return compile(*element.node);
  }

  static bool begins_with_sign(const Node& node) {
    const Node* first = &node;
    while (first->kind == NodeKind::binary) first = as<grammar::Binary>(*first).left;
    return first->kind == NodeKind::unary && as<grammar::Unary>(*first).op != grammar::UnaryOp::logical_not;
  }

  // ---- Expressions --------------------------------------------------------------------------------------------------

  Operand compile(const Node& node) {
    const NestingGuard guard(context_, node.span);
    switch (node.kind) {
      case NodeKind::number: return builder_.constant(as<grammar::Number>(node).value);
      case NodeKind::constant: return compile_name(node, as<grammar::Constant>(node).word);
      case NodeKind::name: return compile_name(node, as<grammar::Name>(node).name);
      case NodeKind::index:
      case NodeKind::scoped_name: return captured(node);
      case NodeKind::unary: return compile_unary(as<grammar::Unary>(node));
      case NodeKind::binary: return compile_binary(as<grammar::Binary>(node));
      case NodeKind::call: return compile_call(as<grammar::Call>(node));
      case NodeKind::function_call: return compile_builtin(as<grammar::FunctionCall>(node));
      case NodeKind::dot: return compile_dot(as<grammar::Dot>(node));
      case NodeKind::error: context_.meet(as<grammar::Error>(node)); throw Failed{};
      case NodeKind::vector: context_.fail(node.span, "expected a number in a function, found a vector");
      case NodeKind::string: context_.fail(node.span, "expected a number in a function, found a string");
      case NodeKind::array: context_.fail(node.span, "expected a number in a function, found an array");
      case NodeKind::function: context_.fail(node.span, "expected a number in a function, found a function");
      case NodeKind::conditional:
        context_.fail(node.span, "`?:` is not allowed in a function", "write `select(a, negative, zero, positive)`");
      default: {
        const Node* const items[] = {&node};
        ElementStream stream(context_, grammar::Items(items), node.span);
        return compile_stream(stream, "an expression");
      }
    }
  }

  /// x and u name the same parameter if only one is declared; so do y and v.
  [[nodiscard]] std::optional<Operand> find_parameter(Symbol name) const {
    static constexpr Symbol kTwins[][2] = {
        {word::kw_x, word::kw_u}, {word::kw_u, word::kw_x}, {word::kw_y, word::kw_v}, {word::kw_v, word::kw_y}};
    const auto find = [&](Symbol wanted) -> std::optional<Operand> {
      // If two parameters have the same name, the last one counts.
      for (std::size_t i = parameters_.size(); i-- > 0;) {
        if (parameters_[i] == wanted) return static_cast<Operand>(i);
      }
      return std::nullopt;
    };
    if (const auto found = find(name)) return found;
    for (const auto& [from, to] : kTwins) {
      if (from == name) return find(to);
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Operand> find_variable(Symbol name) const {
    if (const auto parameter = find_parameter(name)) return parameter;
    const auto local = std::find_if(locals_.rbegin(), locals_.rend(), [&](const Local& l) { return l.name == name; });
    if (local == locals_.rend()) return std::nullopt;
    return local->place;
  }

  Operand compile_name(const Node& node, Symbol name) {
    if (const auto variable = find_variable(name)) return *variable;
    if (node.kind == NodeKind::constant && !is_number_constant(name)) {
      context_.warn(node.span, fmt::format("`{}` is not a parameter of this function; it is 0", context_.text(name)));
      return builder_.constant(0);
    }
    return captured(node);
  }

  static bool is_number_constant(Symbol name) {
    static constexpr Symbol kVectors[] = {word::kw_x, word::kw_y, word::kw_z, word::kw_u, word::kw_v, word::kw_t};
    return std::ranges::find(kVectors, name) == std::end(kVectors);
  }

  /// The present value of an identifier.
  Operand captured(const Node& node) {
    const bool is_name = node.kind == NodeKind::name;
    if (is_name && !context_.scopes.find(as<grammar::Name>(node).name) &&
        !is_newer_value(as<grammar::Name>(node).name)) {
      context_.fail(
          node.span,
          fmt::format("`{}` is neither a parameter nor declared", context_.text(as<grammar::Name>(node).name)),
          context_.suggest_declared(as<grammar::Name>(node).name));
    }
    const Value value = evaluate(context_, node);
    if (!value.is_number()) {
      context_.fail(node.span, fmt::format("expected a number in a function, found {}", describe(value)));
    }
    return builder_.constant(value.number());
  }

  Operand compile_unary(const grammar::Unary& node) {
    const Operand at = builder_.top();
    const Operand operand = compile(*node.operand);
    if (node.op == grammar::UnaryOp::plus) return operand;
    if (node.op == grammar::UnaryOp::logical_not) context_.fail(node.span, "`!` is not allowed in a function");
    return builder_.apply(Opcode::negate, operand, operand, at);
  }

  Operand compile_binary(const grammar::Binary& node) {
    const Operand at = builder_.top();
    const Operand left = compile(*node.left);
    const Operand right = compile(*node.right);
    if (node.op == grammar::BinaryOp::divide && !builder_.constant_value(left) && builder_.constant_value(right) == 0.0)
      context_.fail(node.op_span.empty() ? node.span : node.op_span, "division by zero");
    return builder_.apply(operation_of(node.op), left, right, at);
  }

  // ---- Calls --------------------------------------------------------------------------------------------------------

  Operand compile_argument(const grammar::Argument& argument, SourceSpan span) {
    ElementStream stream(context_, argument, argument.empty() ? span : argument.front()->span);
    return compile_stream(stream, "an argument");
  }

  /// Puts the arguments into registers from the first free one on; it frees all temporaries before it returns.
  Operand place_arguments(std::span<const grammar::Argument> arguments, SourceSpan span) {
    const Operand first = builder_.top();
    for (const grammar::Argument& argument : arguments) {
      const Operand place = builder_.top();
      const Operand value = compile_argument(argument, span);
      builder_.release(place);
      builder_.move(builder_.take(), value);
    }
    return first;
  }

  [[nodiscard]] Slot& callee_slot(const grammar::Call& node) {
    if (node.callee->kind == NodeKind::name && !context_.scopes.find(as<grammar::Name>(*node.callee).name)) {
      const Symbol name = as<grammar::Name>(*node.callee).name;
      const std::string suggestion = context_.suggest_declared(name);
      context_.fail(node.callee->span, fmt::format("undeclared function `{}`", context_.text(name)),
                    suggestion.empty() ? "declare it before this function; a function cannot call itself" : suggestion);
    }
    Slot& slot = find_slot(context_, *node.callee);
    if (slot.value.kind() == ValueKind::poison) throw Failed{};
    return slot;
  }

  /// The first register of a call's results.
  Operand compile_function_call(const grammar::Call& node, const scene::FunctionPointer& callee) {
    if (node.arguments.size() != callee->parameter_count) {
      context_.fail(node.span, fmt::format("this function takes {} argument{}, found {}", callee->parameter_count,
                                           callee->parameter_count == 1 ? "" : "s", node.arguments.size()));
    }
    const Operand first = place_arguments(node.arguments, node.span);
    builder_.call(callee, first);
    builder_.release(first);
    return builder_.take(callee->result_count);
  }

  Operand compile_call(const grammar::Call& node) {
    const Value callee = callee_slot(node).value;
    if (callee.kind() == ValueKind::macro) {
      ElementStream stream(context_, node, callee.as<MacroValue>());
      return compile_stream(stream, "an expression");
    }
    if (callee.kind() != ValueKind::function) {
      context_.fail(node.span, fmt::format("{} cannot be called in a function", describe(callee)),
                    callee.kind() == ValueKind::spline ? "convert it with `function { spline { … } }`" : "");
    }
    const scene::FunctionPointer& function = callee.as<FunctionValue>().function;
    if (function->result_count != 1) {
      context_.fail(node.span,
                    fmt::format("expected a function that yields a number, found one that yields {} terms",
                                function->result_count),
                    "`.x`, `.red` and so on select one term");
    }
    return compile_function_call(node, function);
  }

  Operand compile_dot(const grammar::Dot& node) {
    const Slot* const field = grammar::is_place(*node.base) ? find_slot_if_declared(context_, node) : nullptr;
    if (field) return captured(node);
    if (node.base->kind != NodeKind::call)
      context_.fail(node.span, fmt::format("expected a call before `.{}` in a function", context_.text(node.item)));
    const auto& call = as<grammar::Call>(*node.base);
    const Value callee = callee_slot(call).value;
    if (callee.kind() != ValueKind::function || callee.as<FunctionValue>().function->result_count == 1)
      context_.fail(node.span, fmt::format("`.{}` needs a function that yields a vector", context_.text(node.item)));
    const scene::FunctionPointer function = callee.as<FunctionValue>().function;
    const Operand first = compile_function_call(call, function);
    const std::optional<ResultItem> item =
        node.item == context_.words.hf ? ResultItem{Opcode::height, 2} : result_item(node.item);
    if (!item || item->term >= function->result_count)
      context_.fail(node.span, fmt::format("`.{}` does not exist in the {} terms that this function yields",
                                           context_.text(node.item), function->result_count));
    if (item->operation == Opcode::copy) return static_cast<Operand>(first + item->term);
    builder_.emit(item->operation, first, first, first);
    builder_.release(first);
    return builder_.take();
  }

  // ---- Built-in functions -------------------------------------------------------------------------------------------

  Operand compile_builtin(const grammar::FunctionCall& node) {
    if (node.function == word::kw_select) return compile_select(node);
    if (node.function == word::kw_sum || node.function == word::kw_prod) return compile_loop(node);
    const BuiltinOperation* const builtin = builtin_operation(node.function);
    if (!builtin)
      context_.fail(node.span, fmt::format("`{}` is not allowed in a function", context_.text(node.function)));
    const std::size_t found = node.arguments.size();
    const bool is_variadic = builtin->is_variadic;
    if (is_variadic ? found < 2 : found != builtin->argument_count) {
      context_.fail(node.span, fmt::format("`{}` takes {}{} argument{} in a function, found {}",
                                           context_.text(node.function), is_variadic ? "at least " : "",
                                           builtin->argument_count, builtin->argument_count == 1 ? "" : "s", found));
    }
    const Operand at = builder_.top();
    Operand result = compile_argument(node.arguments[0], node.span);
    if (found == 1) return builder_.apply(builtin->operation, result, result, at);
    for (std::size_t i = 1; i < found; ++i) {
      const Operand next = compile_argument(node.arguments[i], node.span);
      result = builder_.apply(builtin->operation, result, next, at);
    }
    return result;
  }

  /// All arms are computed, as everywhere.
  Operand compile_select(const grammar::FunctionCall& node) {
    if (node.arguments.size() != 3 && node.arguments.size() != 4)
      context_.fail(node.span, fmt::format("`select` takes 3 to 4 arguments, found {}", node.arguments.size()));
    const Operand first = place_arguments(node.arguments, node.span);
    if (node.arguments.size() == 3) builder_.move(builder_.take(), static_cast<Operand>(first + 2));
    builder_.emit(Opcode::select, first, first, first);
    builder_.release(first);
    return builder_.take();
  }

  /// sum(i, a, b, term), prod(i, a, b, factor): i runs from a to b in steps of 1.
  Operand compile_loop(const grammar::FunctionCall& node) {
    const auto is_name = [](const grammar::Argument& argument) {
      return argument.size() == 1 && (argument[0]->kind == NodeKind::name || argument[0]->kind == NodeKind::constant);
    };
    if (node.arguments.size() != 4 || !is_name(node.arguments[0])) {
      context_.fail(node.span, fmt::format("expected `{0}(i, first, last, expression)`", context_.text(node.function)));
    }
    const Node& variable = *node.arguments[0][0];
    const Symbol name =
        variable.kind == NodeKind::name ? as<grammar::Name>(variable).name : as<grammar::Constant>(variable).word;
    if (variable.kind == NodeKind::name && context_.scopes.find(name)) {
      context_.fail(variable.span, fmt::format("`{}` is already declared; choose another name for the loop variable",
                                               context_.text(name)));
    }
    const bool is_sum = node.function == word::kw_sum;
    const Operand result = builder_.take();
    builder_.move(result, builder_.constant(is_sum ? 0 : 1));
    const Operand first = place_arguments(node.arguments.subspan(1, 2), node.span);
    const auto last = static_cast<Operand>(first + 1);
    locals_.push_back({name, first});
    const Operand start = builder_.position();
    builder_.emit(Opcode::loop, 0, first, last);
    const Operand at = builder_.top();
    const Operand term = compile_argument(node.arguments[3], node.span);
    builder_.emit(is_sum ? Opcode::add : Opcode::multiply, result, result, term);
    builder_.release(at);
    builder_.emit(Opcode::repeat, start, first, first);
    check_size();
    builder_.set_target(start, builder_.position());
    locals_.pop_back();
    builder_.release(static_cast<Operand>(result + 1));
    return result;
  }

  Context& context_;
  std::span<const Symbol> parameters_;
  SourceSpan span_;
  ProgramBuilder builder_;
  std::vector<Local> locals_;
};

}  // namespace

scene::Function compile_function(Context& context, std::span<const Symbol> parameters, grammar::Items body,
                                 SourceSpan span) {
  return Compiler(context, parameters, span).compile_body(body);
}

}  // namespace isl::interpreter
