#include "interpreter/readers/settings.h"

#include "interpreter/expressions.h"
#include "interpreter/readers/arguments.h"
#include "interpreter/readers/colour.h"

#include <fmt/format.h>

#include <cmath>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

/// `assumed_gamma 1.0` or `assumed_gamma srgb`.
void read_assumed_gamma(ElementStream& stream, scene::Settings& settings) {
  settings.assumed_gamma_srgb = stream.peek().is_word(word::kw_srgb);
  if (settings.assumed_gamma_srgb) {
    stream.drop();
    settings.assumed_gamma.reset();
  } else {
    settings.assumed_gamma = read_positive(stream, "`assumed_gamma`");
  }
}

/// `tolerance "0.05px"` or `tolerance 1e-4`; kept as text, which the command line's option shares.
void read_tolerance(ElementStream& stream, scene::Settings& settings) {
  Context& context = stream.context();
  const Element lead = stream.peek();
  const bool is_plain = lead.node->kind == grammar::NodeKind::name;
  if (is_plain) {
    stream.drop();
    if (!stream.peek().is(ElementKind::value)) fail_expected(stream, "a number or string after `tolerance`");
    const SourceSpan span = stream.peek().span;
    const Value value = stream.take_value();
    if (value.kind() == ValueKind::string) {
      settings.tolerance = value.as<StringValue>().text;
      return;
    }
    if (!value.is_number() || !(value.number() > 0)) {
      context.fail(span,
                   fmt::format("`tolerance` is above 0 in scene units, or a string as \"0.05px\", found {}",
                               value.is_number() ? fmt::format("{:g}", value.number()) : std::string(describe(value))));
    }
    settings.tolerance = fmt::format("{}", value.number());
    return;
  }
  const double value = read_contextual_number(stream, "a number after `tolerance`");
  if (!(value > 0)) context.fail(lead.span, fmt::format("`tolerance` is above 0, found {:g}", value));
  settings.tolerance = fmt::format("{}", value);
}

/// Settings of things that are not supported yet: without the thing they say nothing.
bool is_setting_without_effect(grammar::Symbol name) {
  return name == word::kw_max_intersections || name == word::kw_number_of_waves || name == word::kw_noise_generator ||
         name == word::kw_irid_wavelength || name == word::kw_hf_gray_16 || name == word::kw_mm_per_unit;
}

void read_item(ElementStream& stream) {
  Context& context = stream.context();
  scene::Settings& settings = context.database.settings;
  static const grammar::Symbol known[] = {word::kw_assumed_gamma, word::kw_ambient_light, word::kw_max_trace_level,
                                          word::kw_adc_bailout,   context.words.solver,   context.words.tolerance};
  const Element next = stream.peek();
  if (const grammar::Symbol lead = leading_name(next); lead != grammar::kNoSymbol) {
    if (lead == context.words.tolerance) return read_tolerance(stream, settings);
    if (lead == context.words.solver) {
      stream.drop();
      settings.solver = read_string(stream, "a solver's name as a string");
      return;
    }
  }
  if (!next.is(ElementKind::word)) return refuse(stream, known);
  switch (static_cast<word::Index>(next.word)) {
    case word::kIndex_assumed_gamma: stream.drop(); return read_assumed_gamma(stream, settings);
    case word::kIndex_ambient_light:
      stream.drop();
      settings.ambient_light = read_colour(stream);
      return;
    case word::kIndex_max_trace_level:
      stream.drop();
      settings.max_trace_level = static_cast<int>(read_number_in(stream, "`max_trace_level`", 1, 256));
      return;
    case word::kIndex_adc_bailout:
      stream.drop();
      settings.adc_bailout = read_number(stream, "a number after `adc_bailout`");
      return;
    case word::kIndex_charset: stream.drop(); return stream.drop();  // every file is UTF-8
    default: break;
  }
  if (!is_setting_without_effect(next.word)) return refuse(stream, known);
  stream.drop();
  if (stream.peek().is(ElementKind::value) ||
      (stream.peek().is(ElementKind::word) && is_colour_word(stream.peek().word))) {
    static_cast<void>(read_colour(stream));
  }
}

}  // namespace

void read_global_settings(Context& context, const Element& block) {
  ElementStream stream(context, block);
  while (!stream.peek().is(ElementKind::end)) read_item(stream);
}

void read_background(Context& context, const Element& block) {
  ElementStream stream(context, block);
  context.database.settings.background = read_colour(stream);
  expect_end(stream);
}

}  // namespace isl::interpreter
