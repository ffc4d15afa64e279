#include "interpreter/readers/words/arguments.h"

#include "grammar/newer_words.h"
#include "grammar/suggest.h"
#include "interpreter/arithmetic.h"
#include "interpreter/deprecated_names.h"
#include "interpreter/expressions.h"
#include "interpreter/readers/words/colour.h"
#include "interpreter/readers/words/supported.h"
#include "interpreter/readers/words/word_homes.h"

#include <fmt/format.h>

#include <cmath>

namespace isl::interpreter {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;
using grammar::Symbol;

std::string describe(Context& context, const Element& element) {
  switch (element.kind) {
    case ElementKind::end: return "the end";
    case ElementKind::value: return "a value";
    case ElementKind::unknown:
    case ElementKind::word: return fmt::format("`{}`", context.text(element.word));
    case ElementKind::block:
      return element.word == grammar::kNoSymbol ? "`{`" : fmt::format("`{} {{`", context.text(element.word));
    case ElementKind::entry: return "`[`";
    case ElementKind::field: return "a field of a dictionary";
    case ElementKind::comma: return "`,`";
    case ElementKind::semicolon: return "`;`";
  }
  return "";
}

namespace {

/// Fails if the name is a word of POV-Ray 3.8 at a place where it has no meaning.
void refuse_newer_word(Context& context, const Element& element) {
  if (!grammar::is_newer_word(element.word)) return;
  context.fail(element.is(ElementKind::block) ? element.word_span : element.span,
               grammar::newer_word_message(context.text(element.word)));
}

/// The word whose block takes a declared name of the value's kind; empty if there is none.
std::string_view block_word(const Value& value) {
  switch (value.kind()) {
    case ValueKind::object: return "object";
    case ValueKind::pigment: return "pigment";
    case ValueKind::normal: return "normal";
    case ValueKind::finish: return "finish";
    case ValueKind::texture: return "texture";
    case ValueKind::material: return "material";
    case ValueKind::interior: return "interior";
    case ValueKind::colour_map: return "color_map";
    case ValueKind::pigment_map: return "pigment_map";
    case ValueKind::normal_map: return "normal_map";
    case ValueKind::slope_map: return "slope_map";
    case ValueKind::texture_map: return "texture_map";
    case ValueKind::statement: return value.as<StatementValue>().statement.kind->word;
    case ValueKind::transform: return "transform";
    case ValueKind::camera: return "camera";
    default: return "";
  }
}

}  // namespace

void fail_expected(ElementStream& stream, std::string_view what) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (next.is(ElementKind::unknown)) {
    refuse_newer_word(context, next);
    const bool is_call = next.node->kind == NodeKind::call;
    std::string hint = context.suggest_declared(next.word);
    const bool expects_word = what.find('`') != std::string_view::npos;
    if (hint.empty() && !is_call && !expects_word)
      hint = fmt::format("declare it before it is used: `#declare {} = …`", context.text(next.word));
    context.fail(
        next.span,
        fmt::format("undeclared {} `{}`, expected {}", is_call ? "macro" : "identifier", context.text(next.word), what),
        std::move(hint));
  }
  if (next.is(ElementKind::end) && stream.word() != grammar::kNoSymbol) {
    // The error's place is the closing bracket.
    const SourceSpan close{next.span.end > 0 ? next.span.end - 1 : 0, next.span.end};
    context.fail(close, fmt::format("expected {}, found the end of `{}`", what, context.text(stream.word())));
  }
  context.fail(next.span, fmt::format("expected {}, found {}", what, describe(context, next)));
}

namespace {

/// Tells how the value can become the expected number.
std::string hint_for_number(const Value& value) {
  if (value.kind() == ValueKind::string) return "`val(…)` converts a string to a number";
  if (value.is_numeric()) return "`.x`, `.y` and so on select one term of a vector, `vlength(…)` gives its length";
  return {};
}

}  // namespace

double read_number(ElementStream& stream, std::string_view what) {
  const Element& next = stream.peek();
  if (!next.is(ElementKind::value)) fail_expected(stream, what);
  const SourceSpan span = next.span;
  const Value value = stream.take_value();
  if (!value.is_number())
    stream.context().fail(span, fmt::format("expected {}, found {}", what, describe(value)), hint_for_number(value));
  return value.number();
}

namespace {

std::string range_text(double low, double high) {
  return std::isinf(high) ? fmt::format("at least {:g}", low) : fmt::format("from {:g} to {:g}", low, high);
}

}  // namespace

double read_number_in(ElementStream& stream, std::string_view what, double low, double high) {
  const SourceSpan span = stream.peek().span;
  const double value = read_number(stream, what);
  if (!(value >= low && value <= high))
    stream.context().fail(span, fmt::format("{} must be {}, found {:g}", what, range_text(low, high), value));
  return value;
}

double read_nearest_number(ElementStream& stream, std::string_view what, double low, double high) {
  const SourceSpan span = stream.peek().span;
  const double value = read_number(stream, what);
  if (value >= low && value <= high) return value;
  const double nearest = value > high ? high : low;
  stream.context().warn(
      span, fmt::format("{} must be {}, found {:g}; {:g} is taken", what, range_text(low, high), value, nearest));
  return nearest;
}

double read_positive(ElementStream& stream, std::string_view what) {
  const SourceSpan span = stream.peek().span;
  const double value = read_number(stream, what);
  if (!(value > 0 && std::isfinite(value)))
    stream.context().fail(span, fmt::format("{} must be above 0, found {:g}", what, value));
  return value;
}

scene::Vec3 to_vector(ElementStream& stream, const Value& value, SourceSpan span, std::string_view what) {
  if (!value.is_numeric()) stream.context().fail(span, fmt::format("expected {}, found {}", what, describe(value)));
  const Value::Terms& terms = value.terms();
  const scene::Vec3 vector = value.is_number() ? scene::Vec3(terms[0]) : scene::Vec3(terms[0], terms[1], terms[2]);
  if (!std::isfinite(vector.x) || !std::isfinite(vector.y) || !std::isfinite(vector.z)) {
    stream.context().fail_not_finite(
        span, fmt::format("expected {}, found <{:g}, {:g}, {:g}>", what, vector.x, vector.y, vector.z));
  }
  return vector;
}

scene::Vec3 read_vector(ElementStream& stream, std::string_view what) {
  const Element& next = stream.peek();
  if (!next.is(ElementKind::value)) fail_expected(stream, what);
  const SourceSpan span = next.span;
  return to_vector(stream, stream.take_value(), span, what);
}

std::string read_string(ElementStream& stream, std::string_view what) {
  if (!stream.peek().is(ElementKind::value)) fail_expected(stream, what);
  const SourceSpan span = stream.peek().span;
  const Value value = stream.take_value();
  if (value.kind() != ValueKind::string)
    stream.context().fail(span, fmt::format("expected {}, found {}", what, describe(value)));
  return value.as<StringValue>().text;
}

std::string read_name_of_file(ElementStream& stream, std::string_view what) {
  const Element next = stream.peek();
  const bool is_literal = next.is(ElementKind::value) && next.node->kind == grammar::NodeKind::string;
  if (!is_literal) return read_string(stream, what);
  stream.drop();
  return std::string(grammar::as<grammar::String>(*next.node).raw);
}

bool read_optional_truth(ElementStream& stream) {
  if (!stream.peek().is(ElementKind::value)) return true;
  return std::abs(read_number(stream, "`on` or `off`")) > kTolerance;
}

void expect_end(ElementStream& stream) {
  if (!stream.peek().is(ElementKind::end)) refuse(stream, {});
}

namespace {

/// True if the element begins a construct of POV-Ray that is not supported here.
bool is_unsupported(const Element& element) {
  return (element.is(ElementKind::block) || element.is(ElementKind::word)) && element.word != grammar::kNoSymbol &&
         is_unsupported_word(element.word);
}

/// `Ball { translate x }` with a declared Ball: the name must stand within the braces of its kind.
void refuse_declared_block(Context& context, const Element& block) {
  const Slot* const slot = without_wrapper(context.scopes.find(block.word));
  if (slot == nullptr || slot->value.kind() == ValueKind::none) return;
  if (slot->value.kind() == ValueKind::poison) throw Failed{};
  const std::string_view name = context.text(block.word);
  const std::string_view word = block_word(slot->value);
  context.fail(block.word_span, fmt::format("`{}` is {}; braces cannot follow its name", name, describe(slot->value)),
               word.empty() ? "" : fmt::format("write `{} {{ {} … }}`", word, name));
}

/// Refuses an unknown name, with a suggestion.
[[noreturn]] void refuse_name(Context& context, const Element& element, std::span<const Symbol> known,
                              const std::string& where) {
  refuse_newer_word(context, element);
  if (element.is(ElementKind::block)) refuse_declared_block(context, element);
  std::vector<std::string_view> candidates;
  for (const Symbol symbol : known) candidates.push_back(context.text(symbol));
  for (const Symbol symbol : context.scopes.declared()) candidates.push_back(context.text(symbol));
  std::string hint = context.hint_of_library(element.word);
  const auto nearest = grammar::closest(context.text(element.word), candidates);
  if (hint.empty() && nearest) hint = fmt::format("did you mean `{}`?", *nearest);
  context.fail(element.is(ElementKind::block) ? element.word_span : element.span,
               fmt::format("`{}` is neither declared nor a word of the language {}", context.text(element.word), where),
               std::move(hint));
}

/// The tokens after it are most often the other terms of a vector or colour.
[[noreturn]] void refuse_comma(ElementStream& stream, SourceSpan span, const std::string& where) {
  const Element next = stream.peek();
  const bool is_term = next.is(ElementKind::value) && next.node->kind < NodeKind::vector;
  stream.context().fail(
      span, fmt::format("unexpected `,` {}", where),
      is_term ? "put the terms of a vector or colour in angle brackets, as in `rgb <1, 0.5, 0>`" : "");
}

}  // namespace

void refuse(ElementStream& stream, std::span<const Symbol> known) {
  Context& context = stream.context();
  const Element next = stream.take();
  const bool is_named_block = next.is(ElementKind::block) && next.word != grammar::kNoSymbol;
  const SourceSpan span = is_named_block ? next.word_span : next.span;
  const std::string where =
      stream.word() == grammar::kNoSymbol ? "here" : fmt::format("in `{}`", context.text(stream.word()));
  if (is_unsupported(next)) {
    context.unsupported(span, context.text(next.word));
    if (next.opened_in != Element::kClosed) ElementStream(context, next).skip_rest();
    return;
  }
  const bool is_unknown_block = is_named_block && !grammar::is_reserved(next.word);
  if (next.is(ElementKind::unknown) || is_unknown_block) refuse_name(context, next, known, where);
  if (next.is(ElementKind::comma)) refuse_comma(stream, span, where);
  if (next.is(ElementKind::value)) {
    const Value value = evaluate(context, *next.node);
    context.fail(span, fmt::format("{} is not allowed {}", describe(value), where));
  }
  context.fail(span, fmt::format("unexpected {} {}", describe(context, next), where),
               hint_for_misplaced(context, next, stream.word()));
}

// ---- Contextual words -----------------------------------------------------------------------------------------------

Symbol leading_name(const Element& element) {
  if (!element.is(ElementKind::unknown) && !element.is(ElementKind::value)) return grammar::kNoSymbol;
  const Node* node = element.node;
  while (node->kind == NodeKind::binary) node = as<grammar::Binary>(*node).left;
  if (node->kind == NodeKind::call) node = as<grammar::Call>(*node).callee;
  return node->kind == NodeKind::name ? as<grammar::Name>(*node).name : grammar::kNoSymbol;
}

namespace {

/// The value of the expression without its leading name: `hardness -a * b` was parsed as `hardness - (a * b)`.
double evaluate_without_lead(Context& context, const Node& node, std::string_view what) {
  if (node.kind == NodeKind::call) {
    const auto& call = as<grammar::Call>(node);
    if (call.arguments.size() != 1) context.fail(node.span, fmt::format("expected {}", what));
    const Value value = evaluate_items(context, call.arguments[0], node.span);
    if (!value.is_number()) context.fail(node.span, fmt::format("expected {}, found {}", what, describe(value)));
    return value.number();
  }
  if (node.kind != NodeKind::binary) context.fail(node.span, fmt::format("expected {}", what));
  const auto& binary = as<grammar::Binary>(node);
  const bool is_bare = binary.left->kind == NodeKind::name;
  const bool has_sign = binary.op == grammar::BinaryOp::add || binary.op == grammar::BinaryOp::subtract;
  if (is_bare && !has_sign) context.fail(node.span, fmt::format("expected {}, found `{}`", what, spelling(binary.op)));
  const double left = is_bare ? 0 : evaluate_without_lead(context, *binary.left, what);
  const double right = evaluate_number(context, *binary.right);
  const Value value = arithmetic(binary.op, {&left, 1}, {&right, 1});
  return value.number();
}

}  // namespace

double read_contextual_number(ElementStream& stream, std::string_view what) {
  const Element word = stream.take();
  if (word.node->kind == NodeKind::name) return read_number(stream, what);
  return evaluate_without_lead(stream.context(), *word.node, what);
}

scene::Vec3 read_normal(ElementStream& stream, std::string_view what) {
  const SourceSpan span = stream.peek().span;
  const scene::Vec3 normal = read_vector(stream, what);
  if (!(normal.length() > 0)) stream.context().fail(span, fmt::format("{} must have a length above 0", what));
  return normal / normal.length();
}

}  // namespace isl::interpreter
