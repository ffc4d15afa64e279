#include "interpreter/functions/functions.h"

#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/functions/compiler.h"
#include "interpreter/functions/pattern_use.h"
#include "interpreter/readers/arguments.h"
#include "interpreter/readers/pattern.h"
#include "interpreter/readers/pigment.h"
#include "interpreter/readers/rvalue.h"
#include "interpreter/readers/spline.h"
#include "interpreter/readers/texture.h"
#include "interpreter/readers/transform.h"
#include "interpreter/records.h"
#include "renderer/patterns/patterns.h"
#include "renderer/scene/queries.h"
#include "renderer/values/function_machine.h"
#include "renderer/values/internal_functions.h"
#include "renderer/values/spline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;
using grammar::Symbol;
using scene::Function;
namespace word = grammar::word;

/// The frame that an evaluation puts on the stack, in units of nesting.
constexpr std::size_t kEvaluationUnits = Function::kMaxFrame * sizeof(double) / kNestingBytes + 8;
constexpr std::size_t kMaxParameters = 56;  ///< POV-Ray's limit

constexpr Symbol kDefaultParameters[] = {word::kw_x, word::kw_y, word::kw_z};

// ---- Making ---------------------------------------------------------------------------------------------------------

/// A function of a body that needs no program; its frame holds arguments and results.
template <class Body>
Function function_of(Body body, std::size_t parameter_count, std::size_t result_count) {
  Function function;
  function.body = std::move(body);
  function.parameter_count = static_cast<std::uint16_t>(parameter_count);
  function.result_count = static_cast<std::uint16_t>(result_count);
  function.frame_size = static_cast<std::uint32_t>(std::max(parameter_count, result_count));
  return function;
}

Function with_use(Function function, const PatternUse& use) {
  function.pattern_depth = use.depth;
  function.missing = use.missing;
  return function;
}

void check_parameters(Context& context, const grammar::Function& node) {
  if (node.parameters.empty()) context.fail(node.span, "a function needs at least one parameter");
  if (node.parameters.size() > kMaxParameters)
    context.fail(node.span,
                 fmt::format("a function has at most {} parameters, found {}", kMaxParameters, node.parameters.size()));
  for (const Symbol name : node.parameters) {
    static constexpr Symbol kAllowed[] = {word::kw_x, word::kw_y, word::kw_z, word::kw_u, word::kw_v};
    const bool is_allowed = !grammar::is_reserved(name) || std::ranges::find(kAllowed, name) != std::end(kAllowed);
    if (!is_allowed)
      context.fail(node.span, fmt::format("`{}` is a reserved word; it cannot name a parameter", context.text(name)));
    const Slot* const slot = context.scopes.find(name);
    if (slot) {
      context.fail(
          node.span,
          fmt::format("parameter `{}` has the name of {} that is declared", context.text(name), describe(slot->value)),
          "give the parameter a name of its own");
    }
  }
}

Function make_internal(Context& context, const grammar::FunctionCall& node) {
  if (node.arguments.size() != 1 || node.arguments[0].size() != 1)
    context.fail(node.span, "`internal` takes the number of a built-in function");
  const double number = evaluate_number(context, *node.arguments[0][0]);
  const auto table = values::internal_functions();
  if (!(number >= 0 && number < static_cast<double>(table.size())) || !table[static_cast<std::size_t>(number)].exists())
    context.fail(node.span, fmt::format("there is no built-in function `internal({:g})`", number));
  const auto i = static_cast<std::uint16_t>(number);
  Function function = function_of(scene::InternalFunction{i}, 3u + table[i].extra_parameters, 1);
  if (table[i].takes_scene_noise) ++function.frame_size;
  if (!table[i].evaluate) function.missing = table[i].name;
  return function;
}

Function make_block_function(Context& context, const grammar::Function& node, ElementStream& stream) {
  const Element block = stream.take();
  const bool is_spline = block.is_block(word::kw_spline);
  if (node.has_parameters)
    context.fail(node.span,
                 fmt::format("a function of a `{}` block has no list of parameters", context.text(block.word)));
  if (is_spline) {
    const std::shared_ptr<const scene::Spline> spline = read_spline(context, block);
    return function_of(scene::SplineFunction{spline}, 1, static_cast<std::size_t>(spline->term_count));
  }
  if (block.is_block(word::kw_transform))
    return function_of(scene::TransformFunction{read_transform_block(context, block)}, 3, 3);
  if (block.is_block(word::kw_pigment)) {
    const scene::Pigment pigment = read_pigment(context, block, context.default_texture.pigment);
    return with_use(function_of(scene::PigmentFunction{pigment}, 3, 5), use_of(context, pigment, node.span));
  }
  if (!block.is_block(word::kw_pattern)) {
    context.fail(
        block.word_span,
        fmt::format("expected an expression, or a `pattern`, `pigment`, `spline` or `transform` block, found `{}`",
                    context.text(block.word)));
  }
  const scene::Pattern pattern = read_pattern_block(context, block);
  return with_use(function_of(scene::PatternFunction{pattern}, 3, 1), use_of(context, pattern, node.span));
}

bool is_internal(const grammar::Items& body) {
  return body.size() == 1 && body[0]->kind == NodeKind::function_call &&
         as<grammar::FunctionCall>(*body[0]).function == word::kw_internal;
}

Function make_body(Context& context, const grammar::Function& node) {
  if (is_internal(node.body)) return make_internal(context, as<grammar::FunctionCall>(*node.body[0]));
  const bool is_block = node.body.size() == 1 && node.body[0]->kind == NodeKind::block;
  if (is_block) {
    ElementStream stream(context, node.body, node.span);
    return make_block_function(context, node, stream);
  }
  if (!node.has_parameters) return compile_function(context, kDefaultParameters, node.body, node.span);
  check_parameters(context, node);
  return compile_function(context, node.parameters, node.body, node.span);
}

// ---- Calling --------------------------------------------------------------------------------------------------------

/// Asks the language's own `inside`.
class Surroundings final : public render::PatternSurroundings {
 public:
  explicit Surroundings(const Context& context) : context_(context) {}
  [[nodiscard]] bool is_inside(const scene::Object& object, const scene::Vec3& point) const override {
    return context_.options.queries->inside(context_.database, object, point);
  }

 private:
  const Context& context_;
};

/// The numbers between a call's parentheses; commas between them are optional, and a macro may yield several.
class Numbers {
 public:
  Numbers(Context& context, const grammar::Call& call) {
    for (const grammar::Argument& argument : call.arguments) {
      if (argument.size() == 1 && argument[0]->kind < NodeKind::word) {
        append(context, call, evaluate_number(context, *argument[0]));
      } else {
        ElementStream stream(context, argument, call.span);
        while (!stream.peek().is(ElementKind::end)) {
          append(context, call, read_number(stream, "an argument"));
          stream.accept_comma();
        }
      }
    }
  }
  [[nodiscard]] std::span<const double> span() const { return std::span<const double>(numbers_).first(count_); }

 private:
  void append(Context& context, const grammar::Call& call, double number) {
    if (count_ == numbers_.size())
      context.fail(call.span, fmt::format("a call takes at most {} arguments", numbers_.size()));
    numbers_[count_++] = number;
  }

  std::array<double, kMaxParameters> numbers_;
  std::size_t count_ = 0;
};

Value to_value(const std::array<double, 5>& terms, int count) { return {count, terms}; }

Value call(Context& context, const grammar::Call& call, const FunctionValue& value) {
  const Function& function = *value.function;
  const Numbers arguments(context, call);
  if (arguments.span().size() != function.parameter_count) {
    context.fail(call.span, fmt::format("this function takes {} argument{}, found {}", function.parameter_count,
                                        function.parameter_count == 1 ? "" : "s", arguments.span().size()));
  }
  if (!function.missing.empty()) {
    context.unsupported(call.span, function.missing);
    throw Failed{};
  }
  const NestingGuard guard(context, call.span, kEvaluationUnits * (1 + function.pattern_depth));
  const Surroundings surroundings(context);
  const render::Patterns patterns(context.database, &surroundings);
  values::Environment environment(values::noise_generator_of(context.noise_generator()),
                                  static_cast<std::uint64_t>(std::min(context.options.limits.max_turns, 1e18)),
                                  &patterns);
  const auto terms = values::evaluate(function, arguments.span(), environment);
  if (environment.is_spent()) {
    context.stop(call.span,
                 fmt::format("this function takes more than {:g} turns and calls", context.options.limits.max_turns),
                 "`--max-turns` raises the limit");
  }
  return function.result_count == 1 ? Value(terms[0]) : to_value(terms, function.result_count);
}

Value call(Context& context, const grammar::Call& call, const SplineValue& value) {
  const scene::Spline& spline = *value.spline;
  scene::SplineKind kind = spline.kind;
  if (call.arguments.empty() || call.arguments.size() > 2) {
    context.fail(call.span, fmt::format("a spline takes a parameter and perhaps its kind, found {} arguments",
                                        call.arguments.size()));
  }
  ElementStream parameter(context, call.arguments[0], call.span);
  const double at = read_number(parameter, "a parameter of the spline");
  expect_end(parameter);
  if (call.arguments.size() == 2) {
    ElementStream word(context, call.arguments[1], call.span);
    const std::optional<scene::SplineKind> other = accept_spline_kind(word);
    if (!other) fail_expected(word, "`linear_spline`, `quadratic_spline`, `cubic_spline` or `natural_spline`");
    kind = *other;
    expect_end(word);
  }
  return to_value(values::evaluate(spline, kind, at), spline.term_count);
}

}  // namespace

namespace {

Value make_value(Context& context, const grammar::Function& node) {
  const NestingGuard guard(context, node.span, kStreamUnits);
  auto function = std::make_shared<const Function>(make_body(context, node));
  std::size_t bytes = sizeof(Function);
  if (const auto* program = std::get_if<scene::Program>(&function->body))
    bytes += program->code.size() * sizeof(scene::Instruction) + program->constants.size() * sizeof(double);
  context.check_memory(node.span, bytes);
  return {ValueKind::function, make_shared_value<FunctionValue>(std::move(function), bytes, context.memory)};
}

}  // namespace

[[gnu::noinline]] Value make_function(Context& context, const grammar::Function& node) {
  if (!node.size.empty()) context.fail(node.span, "a function has a width and height only as an image");
  return make_value(context, node);
}

[[gnu::noinline]] scene::FunctionId make_point_function(Context& context, const grammar::Function& node) {
  const Value value = make_value(context, node);
  const scene::FunctionPointer& function = value.as<FunctionValue>().function;
  if (function->parameter_count != 3)
    context.fail(node.span, fmt::format("a function of points takes x, y and z; this one has {} parameter{}",
                                        function->parameter_count, function->parameter_count == 1 ? "" : "s"));
  const bool is_image = !node.size.empty();
  if (function->result_count != 1 && !(is_image && function->result_count == 5))
    context.fail(node.span, fmt::format("this function yields {} terms, and one is wanted", function->result_count));
  return function_id(context, value.as<FunctionValue>(), node.span);
}

bool is_callable(const Value& value) {
  return value.kind() == ValueKind::function || value.kind() == ValueKind::spline;
}

[[gnu::noinline]] Value call_function(Context& context, const grammar::Call& node, const Value& variable) {
  const NestingGuard guard(context, node.span);
  // Evaluating the arguments may undeclare the variable that holds it.
  const Value callee = variable;  // NOLINT(performance-unnecessary-copy-initialization)
  return callee.kind() == ValueKind::function ? call(context, node, callee.as<FunctionValue>())
                                              : call(context, node, callee.as<SplineValue>());
}

scene::FunctionId function_id(Context& context, const FunctionValue& value, SourceSpan span) {
  if (!value.function->missing.empty()) {
    context.unsupported(span, value.function->missing);
    return scene::kNoFunction;
  }
  return add_record<scene::FunctionId>(context, context.database.functions, value.function);
}

}  // namespace isl::interpreter
