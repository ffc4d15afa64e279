#include "interpreter/readers/textures/finish.h"

#include "interpreter/deprecated_names.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/colour.h"
#include "interpreter/readers/words/said_at.h"
#include "interpreter/records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <variant>

namespace isl::interpreter {
namespace {

using scene::Finish;
namespace word = grammar::word;

using scene::FinishForm;
using scene::FinishItem;

struct FinishRow {
  std::string_view word;
  std::variant<scene::Colour Finish::*, double Finish::*, bool Finish::*> value;
  FinishForm form;
  FinishItem item;
};

constexpr FinishRow kFinishRows[] = {
#define ISL_FINISH_COLOUR(word, grey, dump) {#word, &Finish::word, FinishForm::plain, FinishItem::word},
#define ISL_FINISH_NUMBER(word, otherwise, form, dump) {#word, &Finish::word, FinishForm::form, FinishItem::word},
#define ISL_FINISH_FLAG(word, form, dump) {#word, &Finish::word, FinishForm::form, FinishItem::word},
#include "renderer/scene/finish.def"
};

/// The row of an item with that word; null if there is none.
const FinishRow* row_of(std::string_view word) {
  const auto* const row = std::ranges::find(kFinishRows, word, &FinishRow::word);
  return row == std::end(kFinishRows) || row->form == FinishForm::part ? nullptr : row;
}

/// The items that a block gives as `albedo`: the share of all light that is reflected into the half-space, instead of
/// the peak.
struct Albedos {
  bool diffuse = false, phong = false, specular = false;

  [[nodiscard]] bool& of(FinishItem item) {
    return item == FinishItem::diffuse ? diffuse : item == FinishItem::phong ? phong : specular;
  }

  /// Makes peaks of them, by POV-Ray's factors. As there, what blocks after this one say of brilliance, phong_size and
  /// roughness leaves the peaks alone.
  void apply(Finish& finish) const {
    if (diffuse) {
      const double factor = (finish.brilliance + 1) / 2;
      finish.diffuse *= factor;
      finish.diffuse_back *= factor;
    }
    if (phong) finish.phong *= (finish.phong_size + 1) / 2;
    const double exponent = finish.specular_exponent();
    if (specular) finish.specular *= (exponent + 2) / (4 * (2 - std::exp2(-exponent / 2)));
  }
};

/// Items that are not rows of finish.def.
constexpr ItemWord<FinishItem> kBlockPlaces[] = {{word::kw_reflection, FinishItem::reflection},
                                                 {word::kw_reflection_exponent, FinishItem::exponent},
                                                 {word::kw_irid, FinishItem::irid}};

/// These stand within a block of reflection.
constexpr ItemWord<FinishItem> kReflectionPlaces[] = {{word::kw_fresnel, FinishItem::fresnel_reflection},
                                                      {word::kw_exponent, FinishItem::exponent}};

bool is_finish(const Context& context, const Element& element) {
  if (!element.is(ElementKind::value) || element.node->kind != grammar::NodeKind::name) return false;
  const Slot* const slot = without_wrapper(context.scopes.find(element.word));
  return slot != nullptr && slot->value.kind() == ValueKind::finish;
}

std::string after(ElementStream& stream, grammar::Symbol name) {
  return fmt::format("a number after `{}`", stream.context().text(name));
}

double read_optional_number(ElementStream& stream, std::string_view what, double otherwise) {
  return stream.peek().is(ElementKind::value) ? read_number(stream, what) : otherwise;
}

bool starts_colour(const Element& element) {
  return element.is(ElementKind::value) || (element.is(ElementKind::word) && is_colour_word(element.word));
}

/// A declared finish after other items is not a number; it is reported where items are expected.
bool starts_number(ElementStream& stream) {
  const Element& next = stream.peek();
  if (!next.is(ElementKind::value)) return false;
  return !is_finish(stream.context(), next);
}

/// In POV-Ray an exponent of a reflection that is not above 0 bends all light to black or white.
double read_exponent(ElementStream& stream, std::string_view word) {
  const SourceSpan span = stream.peek().span;
  const double exponent = read_number(stream, fmt::format("a number after `{}`", word));
  if (exponent > 0 && std::isfinite(exponent)) return exponent;
  stream.context().warn(span, fmt::format("`{}` must be above 0, found {:g}; 1 is taken", word, exponent));
  return 1;
}

/// True if the reflection is the same at all angles.
bool is_even(const scene::Reflection& reflection) {
  const scene::Colour &least = reflection.minimum, &most = reflection.maximum;
  return least.red == most.red && least.green == most.green && least.blue == most.blue;
}

double read_number_in_form(ElementStream& stream, std::string_view word, FinishForm form) {
  if (form == FinishForm::positive) return read_exponent(stream, word);
  const std::string what = fmt::format("a number after `{}`", word);
  return form == FinishForm::amount ? read_optional_number(stream, what, 1) : read_number(stream, what);
}

void read_finish_number(ElementStream& stream, Finish& finish, Albedos& albedos, const FinishRow& row,
                        double Finish::*value) {
  if (row.form == FinishForm::albedo) {
    bool& is_albedo = albedos.of(row.item);
    is_albedo = stream.peek().is_word(word::kw_albedo);
    if (is_albedo) stream.drop();
  }
  const SourceSpan span = stream.peek().span;
  finish.*value = read_number_in_form(stream, row.word, row.form);
  if (row.item == FinishItem::fresnel) finish.fresnel_reflection = finish.fresnel != 0;
  if (row.item == FinishItem::roughness && finish.roughness == 0)
    stream.context().warn(span, "`roughness` must be above 0, found 0");
  if (row.item == FinishItem::diffuse && (stream.accept_comma() || starts_number(stream)))
    finish.diffuse_back = read_number(stream, "a number for the light from behind");
}

/// POV-Ray 3.7 reads `use_alpha` and does nothing about it.
void ignore_in_older_scene(Context& context, const Element& element, bool& flag) {
  if (!flag || !context.version.is_stated_below(LanguageVersion::kWithNewerWords)) return;
  flag = false;
  if (context.noted_words.insert(element.word).second)
    context.note(element.span, "`use_alpha` of a finish has no effect before version 3.8 of the language",
                 "`#version 3.8;` at the scene's beginning states the newer version");
}

bool read_row(ElementStream& stream, Finish& finish, Albedos& albedos) {
  const Element next = stream.peek();
  const FinishRow* const row = row_of(stream.context().text(next.word));
  if (!row) return false;
  finish.said_at[row->item] = place_of(stream.context(), next);
  stream.drop();
  if (const auto* const number = std::get_if<double Finish::*>(&row->value)) {
    read_finish_number(stream, finish, albedos, *row, *number);
  } else if (const auto* const flag = std::get_if<bool Finish::*>(&row->value)) {
    finish.** flag = read_optional_truth(stream);
    if (row->item == FinishItem::use_alpha) ignore_in_older_scene(stream.context(), next, finish.use_alpha);
  } else {
    finish.*std::get<scene::Colour Finish::*>(row->value) = read_colour(stream);
  }
  return true;
}

struct ReflectionRow {
  std::string_view word;
  double scene::Reflection::*value;
  FinishForm form;
};

constexpr ReflectionRow kReflectionRows[] = {
#define ISL_REFLECTION_NUMBER(word, otherwise, form) {#word, &scene::Reflection::word, FinishForm::form},
#include "renderer/scene/finish.def"
};

bool read_reflection_number(ElementStream& stream, scene::Reflection& reflection) {
  const Element next = stream.peek();
  if (!next.is(ElementKind::word)) return false;
  const auto* const row = std::ranges::find(kReflectionRows, stream.context().text(next.word), &ReflectionRow::word);
  if (row == std::end(kReflectionRows)) return false;
  stream.drop();
  reflection.*row->value = read_number_in_form(stream, row->word, row->form);
  return true;
}

std::vector<grammar::Symbol> reflection_words(Context& context) {
  std::vector<grammar::Symbol> words{word::kw_fresnel};
  for (const ReflectionRow& row : kReflectionRows) words.push_back(context.symbols.intern(row.word));
  return words;
}

/// `reflection colour`, or `reflection { minimum, maximum fresnel … }`.
void read_reflection_block(Context& context, const Element& block, Finish& finish) {
  ElementStream stream(context, block);
  scene::Reflection& reflection = finish.reflection;
  bool has_one = false;
  if (starts_colour(stream.peek())) {
    reflection.minimum = reflection.maximum = read_colour(stream);
    has_one = !stream.accept_comma() && !starts_colour(stream.peek());
    if (!has_one) reflection.maximum = read_colour(stream);
  }
  while (!stream.peek().is(ElementKind::end)) {
    note_place(context, stream.peek(), kReflectionPlaces, finish.said_at);
    if (stream.peek().is_word(word::kw_fresnel)) {
      stream.drop();
      finish.fresnel_reflection = read_optional_truth(stream);
    } else if (!read_reflection_number(stream, reflection)) {
      refuse(stream, reflection_words(context));
    }
  }
  // Fresnel's formula begins at 0 then.
  if (has_one && finish.fresnel_reflection) reflection.minimum = {};
}

void read_irid(Context& context, const Element& block, Finish& finish) {
  ElementStream stream(context, block);
  finish.irid = read_number(stream, "the amount of `irid`");
  while (!stream.peek().is(ElementKind::end)) {
    if (stream.peek().is_word(word::kw_thickness)) {
      stream.drop();
      finish.irid_thickness = read_number(stream, "a number after `thickness`");
    } else if (stream.peek().is_word(word::kw_turbulence)) {
      stream.drop();
      finish.irid_turbulence = read_number(stream, "a number after `turbulence`");
    } else {
      static constexpr grammar::Symbol kItems[] = {word::kw_thickness, word::kw_turbulence};
      refuse(stream, kItems);
    }
  }
}

/// POV-Ray 3.0 had these items here; today they belong to the interior.
bool read_old_item(ElementStream& stream, Finish& finish) {
  Context& context = stream.context();
  const Element next = stream.peek();
  double unused = 0;
  double* value = nullptr;
  if (next.word == word::kw_ior) value = &finish.old_ior;
  if (next.word == word::kw_caustics) value = &finish.old_caustics;
  if (next.word == word::kw_refraction) value = &unused;
  if (!value) return false;
  context.warn(next.span, fmt::format("`{}` belongs in an `interior`", context.text(next.word)));
  stream.drop();
  *value = read_number(stream, after(stream, next.word));
  return true;
}

bool read_item(ElementStream& stream, Finish& finish, Albedos& albedos) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (next.is_block(word::kw_reflection)) {
    stream.drop();
    read_reflection_block(context, next, finish);
    return true;
  }
  if (next.is_block(word::kw_irid)) {
    stream.drop();
    read_irid(context, next, finish);
    return true;
  }
  if (!next.is(ElementKind::word)) return false;
  if (read_row(stream, finish, albedos) || read_old_item(stream, finish)) return true;
  switch (static_cast<word::Index>(next.word)) {
    case word::kIndex_reflection:
      stream.drop();
      finish.reflection.minimum = finish.reflection.maximum = read_colour(stream);
      if (finish.fresnel != 0) finish.fresnel_reflection = true;
      return true;
    case word::kIndex_reflection_exponent:
      stream.drop();
      finish.reflection.exponent = read_exponent(stream, "reflection_exponent");
      return true;
    default: return false;
  }
}

}  // namespace

std::vector<grammar::Symbol> finish_words(Context& context) {
  std::vector<grammar::Symbol> words{word::kw_reflection, word::kw_reflection_exponent, word::kw_irid};
  for (const FinishRow& row : kFinishRows) {
    if (row.form != FinishForm::part) words.push_back(context.symbols.intern(row.word));
  }
  return words;
}

Finish read_finish(Context& context, const Element& block, const Finish& base) {
  ElementStream stream(context, block);
  Finish finish = base;
  if (stream.peek().is(ElementKind::value)) {
    const SourceSpan span = stream.peek().span;
    const Value value = stream.take_value();
    if (value.kind() != ValueKind::finish)
      context.fail(span, fmt::format("expected a finish or its items, found {}", describe(value)));
    finish = value.as<FinishValue>().finish;
    finish.named_at = context.origin(span);
  }
  Albedos albedos;
  while (!stream.peek().is(ElementKind::end)) {
    if (is_finish(context, stream.peek()))
      context.fail(stream.peek().span, "put the name of a declared finish first in its block");
    note_place(context, stream.peek(), kBlockPlaces, finish.said_at);
    if (!read_item(stream, finish, albedos)) refuse(stream, finish_words(context));
  }
  albedos.apply(finish);
  // A mirror with one colour begins at 0 with Fresnel's formula, else that would change nothing.
  if (finish.fresnel != 0 && finish.fresnel_reflection && is_even(finish.reflection)) finish.reflection.minimum = {};
  return finish;
}

scene::FinishId finish_id(Context& context, const Finish& finish) {
  static const Finish kDefault;
  if (RecordTable<Finish>::is_same(finish, kDefault)) return scene::kDefaultFinish;
  return share_record<scene::FinishId>(context, context.finish_table, context.database.finishes, finish);
}

}  // namespace isl::interpreter
