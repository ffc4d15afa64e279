// Calls of functions and splines in a scene's expressions: arguments, limits, results.
#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/functions/functions.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/spline.h"
#include "renderer/patterns/patterns.h"
#include "renderer/scene/queries.h"
#include "renderer/values/function_machine.h"
#include "renderer/values/spline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace isl::interpreter {
namespace {

using grammar::NodeKind;
using scene::Function;

/// The stack frame of one evaluation, in units of nesting.
constexpr std::size_t kEvaluationUnits = Function::kMaxFrame * sizeof(double) / kNestingBytes + 8;

/// Answers as the language's own `inside` does.
class Surroundings final : public render::PatternSurroundings {
 public:
  explicit Surroundings(const Context& context) : context_(context) {}
  [[nodiscard]] bool is_inside(const scene::Object& object, const scene::Vec3& point,
                               StepCounter& steps) const override {
    const bool is_in = context_.options.queries->inside(context_.database, object, point);
    if (context_.options.queries->refusal()) steps.spend();
    return is_in;
  }
  [[nodiscard]] double field_of(const scene::Object& object, const scene::Vec3& point,
                                StepCounter& steps) const override {
    const double field = context_.options.queries->field(context_.database, object, point);
    if (context_.options.queries->refusal()) steps.spend();
    return field;
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

/// Decodes the images that were read since the last call of a function with patterns.
void prepare_images(Context& context, const grammar::Call& call) {
  const std::size_t count = context.database.images.size();
  if (context.images.size() == count || !context.options.images) return;
  context.database.settings.language_version = context.version.of_defaults();
  const std::vector<bool> all(count, true);
  if (const auto refusal = context.options.images->prepare(context.database, all, context.images))
    context.fail(call.span, refusal->message, refusal->hint);
}

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
  if (function.pattern_depth > 0) prepare_images(context, call);
  const Surroundings surroundings(context);
  const render::Patterns patterns(context.database, &surroundings, scene::Settings{}.number_of_waves, &context.images);
  values::Environment environment(values::noise_generator_of(context.noise_generator()), context.run, &patterns);
  const auto terms = values::evaluate(function, arguments.span(), environment);
  if (environment.is_spent()) {
    context.check_stop(call.span);
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
    context.fail(call.span, fmt::format("a spline takes a parameter and optionally its kind, found {} arguments",
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

}  // namespace isl::interpreter
