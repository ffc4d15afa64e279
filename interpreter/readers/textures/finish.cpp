#include "interpreter/readers/textures/finish.h"

#include "interpreter/deprecated_names.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/colour.h"
#include "interpreter/readers/words/said_at.h"
#include "interpreter/records.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::interpreter {
namespace {

using scene::Finish;
namespace word = grammar::word;

/// An item that is one number; it may have an `albedo` before it if there is a flag for it.
struct FinishRow {
  grammar::Symbol word;
  double Finish::*value;
  bool Finish::*albedo = nullptr;
};

constexpr FinishRow kFinishNumbers[] = {
    {word::kw_diffuse, &Finish::diffuse, &Finish::diffuse_albedo},
    {word::kw_brilliance, &Finish::brilliance},
    {word::kw_phong, &Finish::phong, &Finish::phong_albedo},
    {word::kw_phong_size, &Finish::phong_size},
    {word::kw_specular, &Finish::specular, &Finish::specular_albedo},
    {word::kw_roughness, &Finish::roughness},
    {word::kw_crand, &Finish::crand},
};

struct ColourRow {
  grammar::Symbol word;
  scene::Colour Finish::*value;
};

constexpr ColourRow kColours[] = {{word::kw_ambient, &Finish::ambient}, {word::kw_emission, &Finish::emission}};

struct FinishFlag {
  grammar::Symbol word;
  bool Finish::*value;
};

constexpr FinishFlag kFinishFlags[] = {{word::kw_conserve_energy, &Finish::conserve_energy},
                                       {word::kw_use_alpha, &Finish::use_alpha}};

using scene::FinishItem;

/// `albedo` stands within these items, and `fresnel` and `exponent` within a block of reflection.
constexpr ItemWord<FinishItem> kFinishPlaces[] = {{word::kw_ambient, FinishItem::ambient},
                                                  {word::kw_emission, FinishItem::emission},
                                                  {word::kw_diffuse, FinishItem::diffuse},
                                                  {word::kw_phong, FinishItem::phong},
                                                  {word::kw_specular, FinishItem::specular},
                                                  {word::kw_metallic, FinishItem::metallic},
                                                  {word::kw_reflection, FinishItem::reflection},
                                                  {word::kw_reflection_exponent, FinishItem::exponent},
                                                  {word::kw_irid, FinishItem::irid},
                                                  {word::kw_crand, FinishItem::crand},
                                                  {word::kw_conserve_energy, FinishItem::conserve_energy},
                                                  {word::kw_use_alpha, FinishItem::use_alpha}};

constexpr ItemWord<FinishItem> kReflectionPlaces[] = {{word::kw_fresnel, FinishItem::fresnel},
                                                      {word::kw_exponent, FinishItem::exponent}};

constexpr grammar::Symbol kFinishWords[] = {word::kw_ambient,
                                            word::kw_emission,
                                            word::kw_diffuse,
                                            word::kw_brilliance,
                                            word::kw_phong,
                                            word::kw_phong_size,
                                            word::kw_specular,
                                            word::kw_roughness,
                                            word::kw_metallic,
                                            word::kw_reflection,
                                            word::kw_reflection_exponent,
                                            word::kw_irid,
                                            word::kw_crand,
                                            word::kw_conserve_energy,
                                            word::kw_use_alpha};

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

bool read_number_row(ElementStream& stream, Finish& finish) {
  const grammar::Symbol name = stream.peek().word;
  const auto* const row = std::ranges::find(kFinishNumbers, name, &FinishRow::word);
  if (row == std::end(kFinishNumbers)) return false;
  stream.drop();
  if (row->albedo) {
    finish.*row->albedo = stream.peek().is_word(word::kw_albedo);
    if (finish.*row->albedo) stream.drop();
  }
  const SourceSpan span = stream.peek().span;
  finish.*row->value = read_number(stream, after(stream, name));
  if (name == word::kw_roughness && finish.roughness == 0)
    stream.context().warn(span, "`roughness` must be above 0, found 0");
  if (name == word::kw_diffuse && (stream.accept_comma() || starts_number(stream))) {
    finish.diffuse_back = read_number(stream, "a number for the light from behind");
  }
  return true;
}

/// `reflection colour`, or `reflection { minimum, maximum fresnel … }`.
void read_reflection_block(Context& context, const Element& block, Finish& finish) {
  ElementStream stream(context, block);
  scene::Reflection& reflection = finish.reflection;
  if (starts_colour(stream.peek())) {
    reflection.minimum = reflection.maximum = read_colour(stream);
    if (stream.accept_comma() || starts_colour(stream.peek())) reflection.maximum = read_colour(stream);
  }
  while (!stream.peek().is(ElementKind::end)) {
    note_place(context, stream.peek(), kReflectionPlaces, finish.said_at);
    switch (static_cast<word::Index>(stream.peek().word)) {
      case word::kIndex_fresnel:
        stream.drop();
        finish.fresnel = read_optional_truth(stream);
        break;
      case word::kIndex_falloff:
        stream.drop();
        reflection.falloff = read_number(stream, "a number after `falloff`");
        break;
      case word::kIndex_exponent:
        stream.drop();
        reflection.exponent = read_positive(stream, "`exponent`");
        break;
      case word::kIndex_metallic:
        stream.drop();
        reflection.metallic = read_optional_number(stream, "a number after `metallic`", 1);
        break;
      default: {
        static constexpr grammar::Symbol kItems[] = {word::kw_fresnel, word::kw_falloff, word::kw_exponent,
                                                     word::kw_metallic};
        refuse(stream, kItems);
      }
    }
  }
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

bool read_item(ElementStream& stream, Finish& finish) {
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
  if (read_number_row(stream, finish) || read_old_item(stream, finish)) return true;
  if (const auto* const row = std::ranges::find(kColours, next.word, &ColourRow::word); row != std::end(kColours)) {
    stream.drop();
    finish.*row->value = read_colour(stream);
    return true;
  }
  if (const auto* const row = std::ranges::find(kFinishFlags, next.word, &FinishFlag::word);
      row != std::end(kFinishFlags)) {
    stream.drop();
    finish.*row->value = read_optional_truth(stream);
    return true;
  }
  switch (static_cast<word::Index>(next.word)) {
    case word::kIndex_metallic:
      stream.drop();
      finish.metallic = read_optional_number(stream, "a number after `metallic`", 1);
      return true;
    case word::kIndex_reflection:
      stream.drop();
      finish.reflection.minimum = finish.reflection.maximum = read_colour(stream);
      return true;
    case word::kIndex_reflection_exponent:
      stream.drop();
      finish.reflection.exponent = read_positive(stream, "`reflection_exponent`");
      return true;
    default: return false;
  }
}

}  // namespace

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
  while (!stream.peek().is(ElementKind::end)) {
    if (is_finish(context, stream.peek()))
      context.fail(stream.peek().span, "put the name of a declared finish first in its block");
    note_place(context, stream.peek(), kFinishPlaces, finish.said_at);
    if (!read_item(stream, finish)) refuse(stream, kFinishWords);
  }
  return finish;
}

scene::FinishId finish_id(Context& context, const Finish& finish) {
  static const Finish kDefault;
  if (RecordTable<Finish>::is_same(finish, kDefault)) return scene::kDefaultFinish;
  return share_record<scene::FinishId>(context, context.finish_table, context.database.finishes, finish);
}

}  // namespace isl::interpreter
