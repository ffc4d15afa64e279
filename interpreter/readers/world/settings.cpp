#include "interpreter/readers/world/settings.h"

#include "interpreter/expressions.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/colour.h"
#include "interpreter/readers/world/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

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

/// `tolerance "0.05px"` or `tolerance 1e-4`; kept as text, the form that the command line's option has too.
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
                   fmt::format("`tolerance` must be above 0 in scene units, or a string such as \"0.05px\", found {}",
                               value.is_number() ? fmt::format("{:g}", value.number()) : std::string(describe(value))));
    }
    settings.tolerance = fmt::format("{}", value.number());
    return;
  }
  const double value = read_contextual_number(stream, "a number after `tolerance`");
  if (!(value > 0)) context.fail(lead.span, fmt::format("`tolerance` must be above 0, found {:g}", value));
  settings.tolerance = fmt::format("{}", value);
}

// ---- POV-Ray's items of one value -----------------------------------------------------------------------------------

void read_ambient_light(ElementStream& stream, scene::Settings& settings) {
  settings.ambient_light = read_colour(stream);
}

void read_irid_wavelength(ElementStream& stream, scene::Settings& settings) {
  settings.irid_wavelength = read_colour(stream);
}

void read_adc_bailout(ElementStream& stream, scene::Settings& settings) {
  settings.adc_bailout = read_number(stream, "a number after `adc_bailout`");
}

void read_mm_per_unit(ElementStream& stream, scene::Settings& settings) {
  const SourceSpan span = stream.peek().span;
  const double length = read_number(stream, "a number after `mm_per_unit`");
  if (length > 0 && std::isfinite(length)) {
    settings.mm_per_unit = length;
  } else {
    stream.context().warn(span, fmt::format("`mm_per_unit` must be above 0, found {:g}; it is ignored", length));
  }
}

void read_max_trace_level(ElementStream& stream, scene::Settings& settings) {
  constexpr double kMost = 256;
  const SourceSpan span = stream.peek().span;
  const double level = std::trunc(read_number(stream, "a number after `max_trace_level`"));
  if (!(level >= 1 && level <= kMost))
    stream.context().warn(span, fmt::format("`max_trace_level` must be from 1 to {:g}, found {:g}", kMost, level));
  settings.max_trace_level = level >= 1 ? static_cast<int>(std::min(level, kMost)) : 1;
}

void read_number_of_waves(ElementStream& stream, scene::Settings& settings) {
  constexpr double kMost = 100000;
  const SourceSpan span = stream.peek().span;
  const double number = std::trunc(read_number(stream, "a number after `number_of_waves`"));
  if (!(number >= 1 && number <= kMost))
    stream.context().warn(span, fmt::format("`number_of_waves` must be from 1 to {:g}, found {:g}", kMost, number));
  settings.number_of_waves = static_cast<int>(std::clamp(number, 1.0, kMost));
}

void read_noise_generator(ElementStream& stream, scene::Settings& settings) {
  settings.noise_generator = static_cast<int>(read_number_in(stream, "`noise_generator`", 1, 3));
  stream.context().has_noise_generator = true;
}

/// One of the encodings that POV-Ray knows; every file is read as UTF-8, of which ASCII is a subset.
void read_charset(ElementStream& stream, scene::Settings&) {
  const Element next = stream.peek();
  const bool is_known = next.is_word(word::kw_ascii) || next.is_word(word::kw_utf8) || next.is_word(word::kw_sys);
  if (!is_known) fail_expected(stream, "`ascii`, `utf8` or `sys`");
  if (next.is_word(word::kw_sys))
    stream.context().warn(next.span, "every file is read as UTF-8, whatever the system's encoding");
  stream.drop();
}

/// POV-Ray 3.7 reads it and ignores it.
void read_max_intersections(ElementStream& stream, scene::Settings&) {
  static_cast<void>(read_number(stream, "a number after `max_intersections`"));
}

void read_hf_gray_16(ElementStream& stream, scene::Settings&) {
  const SourceSpan span = stream.peek().span;
  if (read_optional_truth(stream))
    stream.context().warn(span,
                          "`hf_gray_16` has no effect; options of the program set the format of the picture's file");
}

struct SettingWord {
  grammar::Symbol word;
  void (*read)(ElementStream&, scene::Settings&);
};
constexpr SettingWord kSettings[] = {{word::kw_assumed_gamma, read_assumed_gamma},
                                     {word::kw_ambient_light, read_ambient_light},
                                     {word::kw_adc_bailout, read_adc_bailout},
                                     {word::kw_max_trace_level, read_max_trace_level},
                                     {word::kw_irid_wavelength, read_irid_wavelength},
                                     {word::kw_number_of_waves, read_number_of_waves},
                                     {word::kw_noise_generator, read_noise_generator},
                                     {word::kw_mm_per_unit, read_mm_per_unit},
                                     {word::kw_charset, read_charset},
                                     {word::kw_max_intersections, read_max_intersections},
                                     {word::kw_hf_gray_16, read_hf_gray_16}};

/// Reads our own items, which are not reserved words.
bool read_contextual_item(ElementStream& stream) {
  Context& context = stream.context();
  scene::Settings& settings = context.database.settings;
  const Element next = stream.peek();
  const grammar::Symbol lead = leading_name(next);
  if (lead == context.words.tolerance) {
    settings.tolerance_origin = context.origin(next.span);
    read_tolerance(stream, settings);
    return true;
  }
  if (lead != context.words.solver) return false;
  stream.drop();
  settings.solver_origin = context.origin(stream.peek().span);
  settings.solver = read_string(stream, "a solver's name as a string");
  return true;
}

void read_item(ElementStream& stream) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (read_contextual_item(stream) || read_setting_block(stream)) return;
  if (next.is(ElementKind::word)) {
    const auto* const row = std::ranges::find(kSettings, next.word, &SettingWord::word);
    if (row != std::end(kSettings)) {
      stream.drop();
      return row->read(stream, context.database.settings);
    }
  }
  std::vector<grammar::Symbol> known = setting_words(context);
  known.insert(known.end(), {word::kw_assumed_gamma, word::kw_ambient_light, word::kw_max_trace_level,
                             word::kw_adc_bailout, context.words.solver, context.words.tolerance});
  refuse(stream, known);
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
