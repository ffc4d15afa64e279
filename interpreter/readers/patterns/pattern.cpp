#include "interpreter/readers/patterns/pattern.h"

#include "interpreter/readers/patterns/pattern_operands.h"
#include "interpreter/readers/patterns/warp.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/said_at.h"
#include "interpreter/readers/words/transform.h"
#include "interpreter/records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isl::interpreter {
namespace {

using scene::Pattern;
using scene::PatternKind;
using scene::Wave;
namespace word = grammar::word;

/// One pattern: its word, its kind, the number of items in its list, and its operands if it has any.
struct PatternRow {
  grammar::Symbol word;
  PatternKind kind;
  int list = 0;
  Wave wave = Wave::ramp;
  ReadOperands read = nullptr;  ///< after the word, or the whole block if `is_block`
  bool is_block = false;
};

constexpr PatternRow kPatterns[] = {
    {word::kw_agate, PatternKind::agate, 0, Wave::ramp, begin_agate},
    {word::kw_aoi, PatternKind::aoi},
    {word::kw_average, PatternKind::average},
    {word::kw_boxed, PatternKind::boxed},
    {word::kw_bozo, PatternKind::bozo},
    {word::kw_brick, PatternKind::brick, 2, Wave::ramp, begin_brick},
    {word::kw_bump_map, PatternKind::bump_map, 0, Wave::ramp, nullptr, true},
    {word::kw_bumps, PatternKind::bumps},
    {word::kw_cells, PatternKind::cells},
    {word::kw_checker, PatternKind::checker, 2},
    {word::kw_crackle, PatternKind::crackle, 0, Wave::ramp, begin_crackle},
    {word::kw_cubic, PatternKind::cubic, 6},
    {word::kw_cylindrical, PatternKind::cylindrical},
    {word::kw_density_file, PatternKind::density_file, 0, Wave::ramp, read_density_file},
    {word::kw_dents, PatternKind::dents},
    {word::kw_facets, PatternKind::facets, 0, Wave::ramp, begin_facets},
    {word::kw_gradient, PatternKind::gradient, 0, Wave::ramp, read_gradient},
    {word::kw_granite, PatternKind::granite},
    {word::kw_hexagon, PatternKind::hexagon, 3},
    {word::kw_image_map, PatternKind::image_map, 0, Wave::ramp, read_image_operand, true},
    {word::kw_image_pattern, PatternKind::image_pattern, 0, Wave::ramp, read_image_operand, true},
    {word::kw_julia, PatternKind::fractal, 0, Wave::ramp, read_julia},
    {word::kw_leopard, PatternKind::leopard},
    {word::kw_magnet, PatternKind::fractal, 0, Wave::ramp, read_magnet},
    {word::kw_mandel, PatternKind::fractal, 0, Wave::ramp, read_mandel},
    {word::kw_marble, PatternKind::marble, 0, Wave::triangle},
    {word::kw_object, PatternKind::object, 2, Wave::ramp, nullptr, true},
    {word::kw_onion, PatternKind::onion},
    {word::kw_pavement, PatternKind::pavement, 0, Wave::ramp, begin_pavement},
    {word::kw_pigment_pattern, PatternKind::pigment_pattern, 0, Wave::ramp, read_pigment_operand, true},
    {word::kw_planar, PatternKind::planar},
    {word::kw_quilted, PatternKind::quilted, 0, Wave::ramp, begin_quilted},
    {word::kw_radial, PatternKind::radial},
    {word::kw_ripples, PatternKind::ripples},
    {word::kw_slope, PatternKind::slope, 0, Wave::ramp, read_slope},
    {word::kw_spherical, PatternKind::spherical},
    {word::kw_spiral1, PatternKind::spiral1, 0, Wave::triangle, read_spiral},
    {word::kw_spiral2, PatternKind::spiral2, 0, Wave::triangle, read_spiral},
    {word::kw_spotted, PatternKind::spotted},
    {word::kw_square, PatternKind::square, 4},
    {word::kw_tiling, PatternKind::tiling, 0, Wave::ramp, read_tiling},
    {word::kw_triangular, PatternKind::triangular, 6},
    {word::kw_waves, PatternKind::waves},
    {word::kw_wood, PatternKind::wood, 0, Wave::triangle},
    {word::kw_wrinkles, PatternKind::wrinkles},
};

const PatternRow* find_row(const Element& element) {
  const bool is_block = element.is(ElementKind::block);
  if (!is_block && !element.is(ElementKind::word)) return nullptr;
  for (const PatternRow& row : kPatterns) {
    if (row.word != element.word) continue;
    // `slope` is allowed with and without braces.
    return row.is_block == is_block || row.kind == PatternKind::slope ? &row : nullptr;
  }
  return nullptr;
}

/// Patterns that only one host has: a picture's own colours, bumps, facets.
void check_host(Context& context, const Element& element, PatternKind kind, PatternHost host) {
  const bool is_normals = kind == PatternKind::facets || kind == PatternKind::bump_map;
  if (is_normals && host != PatternHost::normal) {
    context.fail(element.is(ElementKind::block) ? element.word_span : element.span,
                 fmt::format("`{}` is allowed only in a `normal`", context.text(element.word)));
  }
  if (kind == PatternKind::image_map && host != PatternHost::pigment) {
    context.fail(element.word_span, "`image_map` is allowed only in a `pigment`", "did you mean `image_pattern`?");
  }
  const bool needs_more = kind == PatternKind::aoi || kind == PatternKind::slope || kind == PatternKind::average;
  if (needs_more && host == PatternHost::function) {
    context.fail(
        element.is(ElementKind::block) ? element.word_span : element.span,
        fmt::format("`{}` depends on more than a point and is not allowed in a function", context.text(element.word)));
  }
}

/// `function { … }` is one value of the stream.
bool is_function(const Element& element) {
  return element.is(ElementKind::value) && element.node->kind == grammar::NodeKind::function;
}

void set_kind(PatternDraft& draft, PatternKind kind, Wave wave) {
  draft.pattern.kind = kind;
  draft.pattern.frequency = scene::default_frequency(kind);
  draft.pattern.wave = wave;
  draft.pattern.operands = std::monostate{};
}

}  // namespace

bool starts_pattern(const Element& element) { return is_function(element) || find_row(element); }

PatternDraft draft_of(Context& context, const Pattern& pattern) {
  return {pattern, context.database.transforms.size()};
}

int list_length(PatternKind kind) {
  const auto* const row = std::ranges::find(kPatterns, kind, &PatternRow::kind);
  return row == std::end(kPatterns) ? 0 : row->list;
}

std::string_view name_of(Context& context, PatternKind kind) {
  const auto* const row = std::ranges::find(kPatterns, kind, &PatternRow::kind);
  return row == std::end(kPatterns) ? "function" : context.text(row->word);
}

bool read_pattern(ElementStream& stream, PatternDraft& draft, PatternHost host, const ReadList& read_list) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (is_function(next)) {
    set_kind(draft, PatternKind::function, Wave::ramp);
    draft.pattern.said_at = place_of(context, next);
    draft.pattern.operands = scene::FunctionOperands{read_function_operand(stream)};
    return true;
  }
  const PatternRow* const row = find_row(next);
  if (!row) return false;
  check_host(context, next, row->kind, host);
  stream.drop();
  set_kind(draft, row->kind, row->wave);
  draft.pattern.said_at = place_of(context, next);
  if (!next.is(ElementKind::block)) {
    if (row->read) row->read(stream, draft.pattern);
    if (row->list > 0 && read_list) read_list(stream, row->kind, row->list);
    return true;
  }
  ElementStream inside(context, next);
  if (row->kind == PatternKind::object) {
    read_object_operand(inside, draft.pattern);
    if (read_list) read_list(inside, row->kind, row->list);
  } else if (row->kind == PatternKind::bump_map) {
    return true;  // its host reads the block, which also holds the size of the bumps
  } else {
    row->read(inside, draft.pattern);
  }
  expect_end(inside);
  return true;
}

// ---- Modifiers ------------------------------------------------------------------------------------------------------

namespace {

struct WaveRow {
  grammar::Symbol word;
  Wave wave;
};

constexpr WaveRow kWaves[] = {
    {word::kw_ramp_wave, Wave::ramp},       {word::kw_triangle_wave, Wave::triangle}, {word::kw_sine_wave, Wave::sine},
    {word::kw_scallop_wave, Wave::scallop}, {word::kw_cubic_wave, Wave::cubic},       {word::kw_poly_wave, Wave::poly},
};

bool read_wave(ElementStream& stream, Pattern& pattern) {
  const auto* const row = std::ranges::find(kWaves, stream.peek().word, &WaveRow::word);
  if (row == std::end(kWaves)) return false;
  stream.drop();
  pattern.wave = row->wave;
  if (row->wave == Wave::poly && stream.peek().is(ElementKind::value)) {
    pattern.exponent = read_number(stream, "a number after `poly_wave`");
  }
  return true;
}

constexpr grammar::Symbol kKnownModifiers[] = {word::kw_turbulence, word::kw_warp,           word::kw_frequency,
                                               word::kw_phase,      word::kw_scale,          word::kw_rotate,
                                               word::kw_translate,  word::kw_noise_generator};

struct NumberRow {
  grammar::Symbol word;
  double Pattern::*value;
};

constexpr NumberRow kNumbers[] = {{word::kw_frequency, &Pattern::frequency}, {word::kw_phase, &Pattern::phase}};

bool read_scalar(ElementStream& stream, Pattern& pattern) {
  const grammar::Symbol name = stream.peek().word;
  if (const auto* const row = std::ranges::find(kNumbers, name, &NumberRow::word); row != std::end(kNumbers)) {
    stream.drop();
    pattern.*row->value = read_number(stream, fmt::format("a number after `{}`", stream.context().text(name)));
    return true;
  }
  if (name == word::kw_noise_generator) {
    stream.drop();
    pattern.noise_generator =
        static_cast<std::uint8_t>(read_number_in(stream, "the number of a `noise_generator`", 0, 3));
    return true;
  }
  return false;
}

}  // namespace

void move(Context& context, PatternDraft& draft, const scene::Transform& transform) {
  auto& transforms = context.database.transforms;
  auto& warps = draft.pattern.warps;
  const auto* const last = warps.empty() ? nullptr : std::get_if<scene::TransformId>(&warps.back());
  if (last && index(*last) >= draft.first_own_transform) {
    transforms[index(*last)] = scene::then(transforms[index(*last)], transform);
    return;
  }
  warps.emplace_back(add_record<scene::TransformId>(context, transforms, transform));
}

bool read_pattern_modifier(ElementStream& stream, PatternDraft& draft) {
  if (const std::optional<scene::Transform> transform = read_transform(stream)) {
    move(stream.context(), draft, *transform);
    return true;
  }
  const Element next = stream.peek();
  if (next.is_block(word::kw_warp)) {
    stream.drop();
    draft.pattern.warps.push_back(read_warp(stream.context(), next));
    return true;
  }
  if (!next.is(ElementKind::word)) return false;
  return read_turbulence_item(stream, draft.pattern.turbulence) || read_wave(stream, draft.pattern) ||
         read_scalar(stream, draft.pattern) || read_operand_modifier(stream, draft.pattern);
}

scene::Pattern read_pattern_block(Context& context, const Element& block) {
  ElementStream stream(context, block);
  PatternDraft draft = draft_of(context, {});
  if (!read_pattern(stream, draft, PatternHost::function, {})) fail_expected(stream, "a pattern");
  while (!stream.peek().is(ElementKind::end)) {
    if (!read_pattern_modifier(stream, draft)) refuse(stream, kKnownModifiers);
  }
  return std::move(draft.pattern);
}

}  // namespace isl::interpreter
