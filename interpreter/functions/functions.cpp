#include "interpreter/functions/functions.h"

#include "interpreter/deprecated_names.h"
#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/functions/compiler.h"
#include "interpreter/functions/pattern_use.h"
#include "interpreter/readers/patterns/pattern.h"
#include "interpreter/readers/textures/pigment.h"
#include "interpreter/readers/textures/texture.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/rvalue.h"
#include "interpreter/readers/words/spline.h"
#include "interpreter/readers/words/transform.h"
#include "interpreter/records.h"
#include "renderer/values/internal_functions.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;
using grammar::Symbol;
using scene::Function;
namespace word = grammar::word;

constexpr Symbol kDefaultParameters[] = {word::kw_x, word::kw_y, word::kw_z};

// ---- Making ---------------------------------------------------------------------------------------------------------

/// A function without a program; its frame holds arguments and results.
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
    const Slot* const slot = without_wrapper(context.scopes.find(name));
    if (slot) {
      context.fail(node.span,
                   fmt::format("parameter `{}` has the same name as {} that is declared", context.text(name),
                               describe(slot->value)),
                   "choose another name for the parameter");
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
  static constexpr Symbol kFunctionBlocks[] = {word::kw_pattern, word::kw_pigment, word::kw_spline, word::kw_transform};
  if (std::ranges::find(kFunctionBlocks, block.word) == std::end(kFunctionBlocks)) {
    context.fail(
        block.word == grammar::kNoSymbol ? block.span : block.word_span,
        fmt::format("expected an expression, or a `pattern`, `pigment`, `spline` or `transform` block, found {}",
                    describe(context, block)));
  }
  if (node.has_parameters)
    context.fail(node.span,
                 fmt::format("a function of a `{}` block has no list of parameters", context.text(block.word)));
  if (block.is_block(word::kw_spline)) {
    const std::shared_ptr<const scene::Spline> spline = read_spline(context, block);
    return function_of(scene::SplineFunction{spline}, 1, static_cast<std::size_t>(spline->term_count));
  }
  if (block.is_block(word::kw_transform))
    return function_of(scene::TransformFunction{read_transform_block(context, block)}, 3, 3);
  if (block.is_block(word::kw_pigment)) {
    const scene::Pigment pigment = read_pigment(context, block, context.default_texture.pigment);
    return with_use(function_of(scene::PigmentFunction{pigment}, 3, 5), use_of(context, pigment, node.span));
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

// ---- As values and records ------------------------------------------------------------------------------------------

Value make_value(Context& context, const grammar::Function& node) {
  const NestingGuard guard(context, node.span, kStreamUnits);
  auto function = std::make_shared<const Function>(make_body(context, node));
  std::size_t bytes = sizeof(Function);
  if (const auto* program = std::get_if<scene::Program>(&function->body))
    bytes += program->code.size() * sizeof(scene::Instruction) + program->constants.size() * sizeof(double);
  context.check_memory(node.span, bytes);
  return {ValueKind::function, make_shared_value<FunctionValue>(std::move(function), bytes, context.memory)};
}

/// kNoFunction, after an error, if the function's formula is not known.
scene::FunctionId function_id(Context& context, const FunctionValue& value, SourceSpan span) {
  if (!value.function->missing.empty()) {
    context.unsupported(span, value.function->missing);
    return scene::kNoFunction;
  }
  return add_record<scene::FunctionId>(context, context.database.functions, value.function);
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
    context.fail(node.span, fmt::format("expected a function that yields a number, found one that yields {} terms",
                                        function->result_count));
  return function_id(context, value.as<FunctionValue>(), node.span);
}

}  // namespace isl::interpreter
