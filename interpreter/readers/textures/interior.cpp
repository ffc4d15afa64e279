#include "interpreter/readers/textures/interior.h"

#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/colour.h"
#include "interpreter/records.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::interpreter {
namespace {

using scene::Interior;
namespace word = grammar::word;

struct InteriorRow {
  grammar::Symbol word;
  double Interior::*value;
};

constexpr InteriorRow kInteriorNumbers[] = {
    {word::kw_ior, &Interior::ior},
    {word::kw_caustics, &Interior::caustics},
    {word::kw_dispersion, &Interior::dispersion},
    {word::kw_dispersion_samples, &Interior::dispersion_samples},
    {word::kw_fade_distance, &Interior::fade_distance},
    {word::kw_fade_power, &Interior::fade_power},
};

constexpr grammar::Symbol kInteriorWords[] = {
    word::kw_ior,           word::kw_caustics,   word::kw_dispersion, word::kw_dispersion_samples,
    word::kw_fade_distance, word::kw_fade_power, word::kw_fade_color};

constexpr double kMinDispersionSamples = 2;

bool read_item(ElementStream& stream, Interior& interior) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (!next.is(ElementKind::word)) return false;
  if (const auto* const row = std::ranges::find(kInteriorNumbers, next.word, &InteriorRow::word);
      row != std::end(kInteriorNumbers)) {
    stream.drop();
    const SourceSpan span = stream.peek().span;
    interior.*row->value = read_number(stream, fmt::format("a number after `{}`", context.text(next.word)));
    if (next.word == word::kw_fade_distance && interior.fade_distance < 0) {
      context.warn(span, fmt::format("`fade_distance` must be above 0, found {:g}: no light is absorbed",
                                     interior.fade_distance));
    }
    if (next.word == word::kw_dispersion && !(interior.dispersion > 0))
      context.warn(span, fmt::format("`dispersion` must be above 0, found {:g}", interior.dispersion));
    if (interior.dispersion_samples < kMinDispersionSamples) {
      context.fail(span,
                   fmt::format("`dispersion_samples` must be at least 2, found {:g}", interior.dispersion_samples));
    }
    return true;
  }
  if (next.word == word::kw_fade_color || next.word == word::kw_fade_colour) {
    stream.drop();
    interior.fade_colour = read_colour(stream);
    return true;
  }
  if (next.word == word::kw_refraction) {
    context.warn(next.span, "`refraction` is not needed: an `ior` refracts");
    stream.drop();
    static_cast<void>(read_number(stream, "a number after `refraction`"));
    return true;
  }
  return false;
}

}  // namespace

scene::InteriorId interior_id(Context& context, const Interior& interior) {
  return share_record<scene::InteriorId>(context, context.interior_table, context.database.interiors, interior);
}

scene::InteriorId read_interior(Context& context, const Element& block) {
  ElementStream stream(context, block);
  Interior interior;
  if (stream.peek().is(ElementKind::value)) {
    const SourceSpan span = stream.peek().span;
    const Value value = stream.take_value();
    if (value.kind() != ValueKind::interior)
      context.fail(span, fmt::format("expected an interior or its items, found {}", describe(value)));
    interior = context.database.interiors[index(value.as<InteriorValue>().id)];
  }
  while (!stream.peek().is(ElementKind::end)) {
    if (!read_item(stream, interior)) refuse(stream, kInteriorWords);
  }
  return interior_id(context, interior);
}

}  // namespace isl::interpreter
