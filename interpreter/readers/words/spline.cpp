#include "interpreter/readers/words/spline.h"

#include "interpreter/arithmetic.h"
#include "interpreter/deprecated_names.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/records.h"
#include "renderer/values/spline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;
using scene::SplineKind;

struct NamedKind {
  grammar::Symbol name;
  SplineKind kind;
};
constexpr NamedKind kSplineKinds[] = {{word::kw_linear_spline, SplineKind::linear},
                                      {word::kw_quadratic_spline, SplineKind::quadratic},
                                      {word::kw_cubic_spline, SplineKind::cubic},
                                      {word::kw_natural_spline, SplineKind::natural}};

/// An element of an array, an entry of a dictionary or a name of another scope: it may hold a spline or a number.
bool is_place(const Element& element) {
  if (!element.is(ElementKind::value)) return false;
  const grammar::NodeKind kind = element.node->kind;
  return kind == grammar::NodeKind::index || kind == grammar::NodeKind::dot || kind == grammar::NodeKind::scoped_name;
}

double to_parameter(Context& context, const Value& value, SourceSpan span) {
  if (!value.is_number())
    context.fail(span, fmt::format("expected a parameter of the spline, found {}", describe(value)));
  return value.number();
}

/// The spline's value at a parameter that was read at `place`.
void read_value(ElementStream& stream, scene::Spline& spline, double parameter, SourceSpan place) {
  Context& context = stream.context();
  if (!std::isfinite(parameter))
    context.fail(place, fmt::format("a parameter of a spline must be finite, found {:g}", parameter));
  stream.accept_comma();
  const Element next = stream.peek();
  if (!next.is(ElementKind::value)) fail_expected(stream, "the spline's value there");
  const Value value = stream.take_value();
  if (!value.is_numeric())
    context.fail(next.span, fmt::format("expected a number or vector, found {}", describe(value)));
  const Value::Terms terms = promoted(value, 2).terms();
  spline.term_count = std::max({spline.term_count, value.term_count(), 2});
  values::insert(spline, parameter, terms);
  stream.accept_comma();
}

void read_point(ElementStream& stream, scene::Spline& spline) {
  const SourceSpan place = stream.peek().span;
  read_value(stream, spline, read_number(stream, "a parameter of the spline"), place);
}

}  // namespace

std::optional<SplineKind> accept_spline_kind(ElementStream& stream) {
  const Element next = stream.peek();
  if (!next.is(ElementKind::word)) return std::nullopt;
  const auto at = std::ranges::find(kSplineKinds, next.word, &NamedKind::name);
  if (at == std::end(kSplineKinds)) return std::nullopt;
  stream.drop();
  return at->kind;
}

std::shared_ptr<const scene::Spline> read_spline(Context& context, const Element& block) {
  ElementStream stream(context, block);
  auto spline = std::make_shared<scene::Spline>();
  const Element first = stream.peek();
  if (first.is(ElementKind::value) && first.word != grammar::kNoSymbol) {
    Slot* const slot = context.scopes.find(first.word);
    if (const Slot* const held = without_wrapper(slot); held && held->value.kind() == ValueKind::spline) {
      stream.drop();
      *spline = *used(context, *slot, first.span).value.as<SplineValue>().spline;
    }
  } else if (is_place(first)) {
    const Value value = stream.take_value();
    if (value.kind() == ValueKind::spline) {
      *spline = *value.as<SplineValue>().spline;
    } else {
      read_value(stream, *spline, to_parameter(context, value, first.span), first.span);
    }
  }
  if (const auto kind = accept_spline_kind(stream)) spline->kind = *kind;
  while (!stream.peek().is(ElementKind::end)) {
    make_room_to_append(context, stream.span(), spline->points);
    read_point(stream, *spline);
  }
  context.check_memory(block.span, spline->points.size() * sizeof(scene::SplinePoint));
  if (spline->points.empty()) context.fail(block.word_span, "a spline needs at least one point");
  values::finish(*spline);
  return spline;
}

}  // namespace isl::interpreter
