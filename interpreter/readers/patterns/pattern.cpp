#include "interpreter/readers/patterns/pattern.h"

#include "interpreter/newer_words.h"
#include "interpreter/readers/patterns/pattern_operands.h"
#include "interpreter/readers/patterns/warp.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/said_at.h"
#include "interpreter/readers/words/transform.h"
#include "interpreter/records.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace isl::interpreter {
namespace {

using render::info_of;
using render::PatternBlock;
using render::PatternHosts;
using render::PatternInfo;
using scene::Pattern;
using scene::PatternKind;
using scene::Wave;
namespace word = grammar::word;

constexpr std::string_view kNames[] = {
    "plain",
#define ISL_PATTERN(name, frequency) #name,
#include "renderer/scene/patterns.def"
#undef ISL_PATTERN
};

bool has_own_number(grammar::Symbol symbol) { return grammar::is_reserved(symbol) || grammar::is_newer_word(symbol); }

/// The kind of pattern that each reserved or newer word begins, `plain` where none does. These words have the same
/// numbers in every scene.
using KindByWord = std::vector<PatternKind>;
const KindByWord& kinds_by_word(Context& context) {
  static const KindByWord kKindByWord = [&context] {
    KindByWord kinds(grammar::newer_word::kIndexAfter, PatternKind::plain);
    for (std::size_t i = 1; i < scene::kPatternKindCount; ++i) {
      for (const std::string_view name : words_of(PatternKind(i))) {
        const grammar::Symbol symbol = context.symbols.intern(name);
        ISL_CHECK(has_own_number(symbol), "the pattern `{}` has no word", name);
        kinds[static_cast<std::size_t>(symbol)] = PatternKind(i);
      }
    }
    return kinds;
  }();
  return kKindByWord;
}

/// The kind of pattern that the element begins; `plain` for none.
PatternKind kind_of(Context& context, const Element& element) {
  const bool is_block = element.is(ElementKind::block);
  if ((!is_block && !element.is(ElementKind::word)) || !has_own_number(element.word)) return PatternKind::plain;
  const PatternKind kind = kinds_by_word(context)[static_cast<std::size_t>(element.word)];
  const PatternBlock block = info_of(kind).block;
  const bool fits = block == PatternBlock::optional || is_block == (block != PatternBlock::none);
  return fits ? kind : PatternKind::plain;
}

struct HostRow {
  bool PatternHosts::*is_host;
  std::string_view name;
};
/// In the order of PatternHost.
constexpr HostRow kHosts[] = {{&PatternHosts::pigment, "pigment"},
                              {&PatternHosts::normal, "normal"},
                              {&PatternHosts::texture, "texture"},
                              {&PatternHosts::function, "function"}};

void check_host(Context& context, const Element& element, PatternKind kind, PatternHost host) {
  const PatternInfo& info = info_of(kind);
  if (info.hosts.*kHosts[static_cast<std::size_t>(host)].is_host) return;
  const SourceSpan span = element.is(ElementKind::block) ? element.word_span : element.span;
  const std::string_view name = context.text(element.word);
  const auto is_host = [&info](const HostRow& row) { return info.hosts.*row.is_host; };
  if (std::ranges::count_if(kHosts, is_host) > 1)
    context.fail(span, fmt::format("`{}` depends on more than a point and is not allowed in a function", name));
  context.fail(span, fmt::format("`{}` is allowed only in a `{}`", name, std::ranges::find_if(kHosts, is_host)->name),
               info.instead.empty() ? std::string() : fmt::format("did you mean `{}`?", info.instead));
}

}  // namespace

std::span<const std::string_view> words_of(PatternKind kind) {
  const std::span<const std::string_view> words = info_of(kind).words;
  return words.empty() ? std::span(&kNames[static_cast<std::size_t>(kind)], 1) : words;
}

bool starts_pattern(Context& context, const Element& element) {
  return is_function(element) || kind_of(context, element) != PatternKind::plain;
}

PatternDraft draft_of(Context& context, const Pattern& pattern) {
  return {pattern, context.database.transforms.size()};
}

void set_kind(PatternDraft& draft, PatternKind kind) {
  const PatternInfo& info = info_of(kind);
  draft.pattern.kind = kind;
  draft.pattern.frequency = scene::default_frequency(kind);
  draft.pattern.wave = info.wave;
  draft.pattern.operands = std::monostate{};
  if (info.operands) draft.pattern.operands = info.operands();
}

std::string_view name_of(PatternKind kind) { return words_of(kind).front(); }

bool read_pattern(ElementStream& stream, PatternDraft& draft, PatternHost host, const ReadList& read_list) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (is_function(next)) {
    set_kind(draft, PatternKind::function);
    draft.pattern.said_at = place_of(context, next);
    draft.pattern.operands = scene::FunctionOperands{read_function_operand(stream)};
    return true;
  }
  const PatternKind kind = kind_of(context, next);
  if (kind == PatternKind::plain) return false;
  check_host(context, next, kind, host);
  stream.drop();
  if (grammar::is_newer_word(next.word)) note_newer_word(context, next.word, next.word_span);
  set_kind(draft, kind);
  draft.pattern.said_at = place_of(context, next);
  const PatternInfo& info = info_of(kind);
  const auto read_rest = [&](ElementStream& from) {
    read_operands(from, draft.pattern, context.text(next.word));
    if (info.list_length > 0 && read_list) read_list(from, kind, info.list_length);
  };
  if (!next.is(ElementKind::block)) {
    read_rest(stream);
  } else if (info.block != PatternBlock::of_host) {
    ElementStream inside(context, next);
    read_rest(inside);
    expect_end(inside);
  }
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

struct ModifierRow {
  grammar::Symbol word;
  double Pattern::*value;
};

constexpr ModifierRow kModifiers[] = {{word::kw_frequency, &Pattern::frequency}, {word::kw_phase, &Pattern::phase}};

bool read_scalar(ElementStream& stream, Pattern& pattern) {
  const grammar::Symbol name = stream.peek().word;
  if (const auto* const row = std::ranges::find(kModifiers, name, &ModifierRow::word); row != std::end(kModifiers)) {
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
  check_operands(stream, draft.pattern);
  return std::move(draft.pattern);
}

}  // namespace isl::interpreter
