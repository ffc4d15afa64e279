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

void read_point(ElementStream& stream, scene::Spline& spline) {
  Context& context = stream.context();
  const SourceSpan place = stream.peek().span;
  const double parameter = read_number(stream, "a parameter of the spline");
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
