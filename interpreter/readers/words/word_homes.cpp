#include "interpreter/readers/words/word_homes.h"

#include "interpreter/readers/objects/objects.h"
#include "interpreter/readers/patterns/pattern.h"
#include "interpreter/readers/textures/finish.h"
#include "interpreter/readers/world/statements.h"
#include "renderer/effects/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <map>

namespace isl::interpreter {
namespace {

using namespace grammar::word;
using grammar::Symbol;

/// A word and one of the blocks that accept it. A word with several has a row for each, the commonest first. Reserved
/// words have the same numbers in every scene.
using Homes = std::multimap<Symbol, Symbol>;

void add(Homes& homes, Symbol block, std::initializer_list<Symbol> words) {
  for (const Symbol word : words) homes.emplace(word, block);
}

/// Patterns stand where their descriptors say.
void add_patterns(Homes& homes, Context& context) {
  for (std::size_t i = 1; i < scene::kPatternKindCount; ++i) {
    const auto kind = scene::PatternKind(i);
    const render::PatternInfo& info = render::info_of(kind);
    const auto add_home = [&](bool is_home, Symbol block) {
      if (!is_home) return;
      for (const std::string_view word : words_of(kind)) homes.emplace(context.symbols.intern(word), block);
    };
    add_home(info.hosts.normal && info.makes_bumps, kw_normal);
    add_home(info.hosts.pigment, kw_pigment);
    add_home(info.hosts.normal && !info.makes_bumps, kw_normal);
    add_home(info.hosts.texture, kw_texture);
  }
}

/// The numbers of statements that effects declare.
void add_statements(Homes& homes, Context& context) {
  for (const scene::StatementKind* const kind : render::statement_kinds()) {
    if (kind->is_setting) continue;  // its items are better known from elsewhere
    std::any record = kind->make();
    for (const scene::StatementField& field : kind->fields) {
      const scene::FieldPlace place = field.place(record);
      if (std::holds_alternative<double*>(place) || std::holds_alternative<int*>(place))
        homes.emplace(context.symbols.intern(field.word), context.symbols.intern(kind->word));
    }
  }
}

Homes make_homes(Context& context) {
  Homes homes;
  for (const Symbol word : finish_words(context)) homes.emplace(word, kw_finish);
  add(homes, kw_interior,
      {kw_ior, kw_caustics, kw_dispersion, kw_dispersion_samples, kw_fade_distance, kw_fade_power, kw_fade_color,
       kw_fade_colour});
  add(homes, kw_pigment,
      {kw_color,         kw_colour,    kw_rgb,         kw_rgbf,        kw_rgbt,        kw_rgbft,        kw_srgb,
       kw_srgbf,         kw_srgbt,     kw_srgbft,      kw_red,         kw_green,       kw_blue,         kw_filter,
       kw_transmit,      kw_color_map, kw_colour_map,  kw_pigment_map, kw_quick_color, kw_quick_colour, kw_turbulence,
       kw_octaves,       kw_omega,     kw_lambda,      kw_frequency,   kw_phase,       kw_warp,         kw_ramp_wave,
       kw_triangle_wave, kw_sine_wave, kw_scallop_wave});
  add(homes, kw_normal,
      {kw_bump_size, kw_normal_map, kw_slope_map, kw_turbulence, kw_octaves, kw_omega, kw_lambda, kw_frequency,
       kw_phase, kw_warp, kw_ramp_wave, kw_triangle_wave, kw_sine_wave, kw_scallop_wave});
  add(homes, kw_texture, {kw_texture_map, kw_tiles});
  add(homes, kw_camera,
      {kw_location, kw_look_at, kw_right, kw_up, kw_direction, kw_sky, kw_angle, kw_aperture, kw_focal_point,
       kw_blur_samples, kw_confidence, kw_variance, kw_bokeh, kw_perspective, kw_orthographic, kw_fisheye,
       kw_ultra_wide_angle, kw_omnimax, kw_panoramic});
  add(homes, kw_light_source,
      {kw_spotlight, kw_parallel, kw_point_at, kw_tightness, kw_falloff, kw_radius, kw_area_light, kw_adaptive,
       kw_jitter, kw_circular, kw_orient, kw_area_illumination, kw_shadowless, kw_looks_like, kw_projected_through});
  add(homes, kw_blob, {kw_threshold, kw_component, kw_strength});
  add(homes, kw_light_group, {kw_global_lights});
  add(homes, kw_global_settings,
      {kw_assumed_gamma, kw_ambient_light, kw_adc_bailout, kw_max_trace_level, kw_irid_wavelength, kw_number_of_waves,
       kw_noise_generator, kw_mm_per_unit, kw_charset, kw_max_intersections, kw_hf_gray_16, kw_radiosity, kw_photons});
  add_patterns(homes, context);
  add_statements(homes, context);
  return homes;
}

bool is_one_of(Symbol word, std::initializer_list<Symbol> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// True for a word that belongs to no block: inside a block, most likely a `}` is missing.
bool is_of_top_level(const Context& context, const Element& element) {
  return element.is(ElementKind::block) && (is_one_of(element.word, {kw_camera, kw_background, kw_global_settings}) ||
                                            statement_kind(context, element.word) != nullptr);
}

/// True for a word that belongs to an object's modifiers, and to none of the blocks inside it.
bool is_of_objects(Symbol word) {
  return is_one_of(word,
                   {kw_texture, kw_pigment, kw_normal, kw_finish, kw_material, kw_interior, kw_no_shadow, kw_no_image,
                    kw_no_reflection, kw_hollow, kw_double_illuminate, kw_clipped_by, kw_bounded_by});
}

bool is_directive(Symbol word) {
  return is_one_of(word, {kw_case, kw_debug, kw_declare, kw_else, kw_end, kw_for, kw_if, kw_ifdef, kw_include, kw_local,
                          kw_macro, kw_switch, kw_while});
}

/// True if the blocks of this word hold objects.
bool holds_objects(Symbol word) {
  return is_one_of(word, {kw_blob, kw_union, kw_merge, kw_intersection, kw_difference, kw_light_group});
}

std::string hint_for_object(Context& context, Symbol stream_word) {
  if (stream_word == kw_blob) return "the components of a `blob` come before its modifiers: move this before them";
  if (holds_objects(stream_word)) {
    return fmt::format("the objects of `{}` come before its modifiers: move this before them",
                       context.text(stream_word));
  }
  return stream_word == grammar::kNoSymbol ? "" : "check for a missing `}` before it";
}

std::string hint_for_word(Context& context, const Element& element, Symbol stream_word) {
  static const Homes homes = make_homes(context);
  const auto [first, last] = homes.equal_range(element.word);
  if (first == last) return {};
  const bool is_at_home = std::any_of(first, last, [&](const auto& row) { return row.second == stream_word; });
  if (is_at_home) return {};
  const std::string_view name = context.text(element.word);
  const Symbol home = first->second;
  const char* const braces = element.is(ElementKind::block) ? " { … }" : " …";
  return fmt::format("`{0}` belongs in `{1}`: write `{1} {{ {0}{2} }}`", name, context.text(home), braces);
}

}  // namespace

std::string hint_for_misplaced(Context& context, const Element& element, Symbol stream_word) {
  if (!element.is(ElementKind::word) && !element.is(ElementKind::block)) return {};
  if (element.is(ElementKind::word) && is_directive(element.word))
    return fmt::format("a directive begins with `#`: write `#{}`", context.text(element.word));
  if (element.is(ElementKind::block) && is_object_word(element.word)) return hint_for_object(context, stream_word);
  if (stream_word == kw_blob && element.word == kw_threshold)
    return "`threshold` comes before the modifiers of the blob";
  if (element.word == kw_strength && is_object_word(stream_word)) {
    return "in a component of a `blob`, `strength` comes right after the component's numbers, before transforms and "
           "textures";
  }
  const bool is_inside = stream_word != grammar::kNoSymbol;
  if (is_inside && is_of_top_level(context, element))
    return fmt::format("a `{}` is not allowed inside another block: check for a missing `}}` before it",
                       context.text(element.word));
  const bool is_in_texture = is_one_of(stream_word, {kw_pigment, kw_normal, kw_finish, kw_interior});
  if (is_in_texture && is_of_objects(element.word)) {
    return fmt::format("`{}` belongs beside `{}`, not inside it: check for a missing `}}` before it",
                       context.text(element.word), context.text(stream_word));
  }
  return hint_for_word(context, element, stream_word);
}

}  // namespace isl::interpreter
