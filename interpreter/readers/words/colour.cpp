#include "interpreter/readers/words/colour.h"

#include "interpreter/arithmetic.h"
#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace isl::interpreter {
namespace {

using scene::Colour;
namespace word = grammar::word;

/// The colour words that take one vector. `fourth` is the meaning of its fourth term.
struct VectorForm {
  grammar::Symbol word;
  int terms;
  bool fourth_is_transmit;
  bool is_srgb;
};

constexpr VectorForm kVectorForms[] = {
    {word::kw_rgb, 3, false, false},   {word::kw_rgbf, 4, false, false},  {word::kw_rgbt, 4, true, false},
    {word::kw_rgbft, 5, false, false}, {word::kw_srgb, 3, false, true},   {word::kw_srgbf, 4, false, true},
    {word::kw_srgbt, 4, true, true},   {word::kw_srgbft, 5, false, true},
};

const VectorForm* find_form(grammar::Symbol name) {
  for (const VectorForm& form : kVectorForms) {
    if (form.word == name) return &form;
  }
  return nullptr;
}

/// Converts an sRGB-encoded component to the scene's working space.
double decoded(const scene::Settings& settings, double encoded) {
  if (settings.assumed_gamma_srgb) return encoded;
  // IEC 61966-2-1.
  const double linear = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
  const double gamma = settings.assumed_gamma.value_or(1);
  return gamma == 1 ? linear : std::pow(linear, 1 / gamma);
}

Colour read_vector_form(ElementStream& stream, const VectorForm& form) {
  Context& context = stream.context();
  const Element keyword = stream.take();
  const Element& next = stream.peek();
  if (!next.is(ElementKind::value)) fail_expected(stream, fmt::format("a colour after `{}`", context.text(form.word)));
  const SourceSpan span = next.span;
  const Value value = stream.take_value();
  if (!value.is_numeric()) context.fail(span, fmt::format("expected a colour, found {}", describe(value)));
  if (value.term_count() > form.terms) {
    context.warn(span,
                 fmt::format("`{}` takes {} terms, found {}", context.text(form.word), form.terms, describe(value)));
  }
  if (value.term_count() == 2) {
    context.warn(span, fmt::format("`{}` takes {} terms, found {}; missing terms are 0", context.text(form.word),
                                   form.terms, describe(value)));
  }
  const Value full = promoted(value, form.terms);
  Value::Terms c = full.terms();
  if (form.fourth_is_transmit) {
    c[4] = c[3];
    c[3] = 0;
  }
  if (form.is_srgb) {
    const scene::Settings& settings = context.database.settings;
    if (!settings.assumed_gamma && !settings.assumed_gamma_srgb && context.version.of_defaults() < 3.7) {
      context.fail(keyword.span, "`srgb` colours need `assumed_gamma` in `global_settings`, or `#version 3.7`");
    }
    for (int i = 0; i < 3; ++i) c[i] = decoded(settings, c[i]);
  }
  return {c[0], c[1], c[2], c[3], c[4]};
}

double* find_component(Colour& colour, grammar::Symbol name) {
  if (name == word::kw_red) return &colour.red;
  if (name == word::kw_green) return &colour.green;
  if (name == word::kw_blue) return &colour.blue;
  if (name == word::kw_filter) return &colour.filter;
  if (name == word::kw_transmit) return &colour.transmit;
  return nullptr;
}

void read_components(ElementStream& stream, Colour& colour) {
  while (is_colour_component(stream.peek())) {
    const grammar::Symbol name = stream.take().word;
    *find_component(colour, name) =
        read_number(stream, fmt::format("a number after `{}`", stream.context().text(name)));
  }
}

}  // namespace

bool is_colour_word(grammar::Symbol name) {
  Colour ignored;
  return name == word::kw_color || name == word::kw_colour || find_form(name) || find_component(ignored, name);
}

bool is_colour_component(const Element& element) {
  Colour ignored;
  return element.is(ElementKind::word) && find_component(ignored, element.word);
}

Colour read_colour(ElementStream& stream) {
  while (stream.peek().is_word(word::kw_color) || stream.peek().is_word(word::kw_colour)) stream.drop();
  const Element next = stream.peek();
  Colour colour;
  if (next.is(ElementKind::value)) {
    const Value value = stream.take_value();
    if (!value.is_numeric())
      stream.context().fail(next.span, fmt::format("expected a colour, found {}", describe(value)));
    colour = to_colour(value);
  } else if (const VectorForm* form = next.is(ElementKind::word) ? find_form(next.word) : nullptr) {
    colour = read_vector_form(stream, *form);
  } else if (!is_colour_component(next)) {
    fail_expected(stream, "a colour");
  }
  read_components(stream, colour);
  return colour;
}

Value read_colour_after(ElementStream& stream, const Value& value) {
  Colour colour = to_colour(value);
  read_components(stream, colour);
  return to_value(colour);
}

Value to_value(const Colour& c) { return {5, {c.red, c.green, c.blue, c.filter, c.transmit}}; }

Colour to_colour(const Value& value) {
  const Value full = promoted(value, 5);
  const Value::Terms& c = full.terms();
  return {c[0], c[1], c[2], c[3], c[4]};
}

}  // namespace isl::interpreter
