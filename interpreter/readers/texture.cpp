#include "interpreter/readers/texture.h"

#include "interpreter/readers/arguments.h"
#include "interpreter/readers/colour.h"
#include "interpreter/readers/transform.h"

#include <fmt/format.h>

namespace isl::interpreter {
namespace {

using scene::Finish;
using scene::Pigment;
using scene::Texture;
namespace word = grammar::word;

/// Reads the numbers of a finish; false where the next element is none of them.
bool read_finish_item(ElementStream& stream, Finish& finish) {
  const Element next = stream.peek();
  if (!next.is(ElementKind::word)) return false;
  switch (static_cast<word::Index>(next.word)) {
    case word::kIndex_ambient:
      stream.drop();
      finish.ambient = read_colour(stream);
      return true;
    case word::kIndex_diffuse:
      stream.drop();
      finish.diffuse = read_number(stream, "a number after `diffuse`");
      return true;
    case word::kIndex_brilliance:
      stream.drop();
      finish.brilliance = read_number(stream, "a number after `brilliance`");
      return true;
    case word::kIndex_phong:
      stream.drop();
      finish.phong = read_number(stream, "a number after `phong`");
      return true;
    case word::kIndex_phong_size:
      stream.drop();
      finish.phong_size = read_number(stream, "a number after `phong_size`");
      return true;
    case word::kIndex_specular:
      stream.drop();
      finish.specular = read_number(stream, "a number after `specular`");
      return true;
    case word::kIndex_roughness:
      stream.drop();
      finish.roughness = read_positive(stream, "`roughness`");
      return true;
    default: return false;
  }
}

/// An identifier at the start of a block, of the block's own kind.
template <class Wanted>
const Wanted* read_identifier(ElementStream& stream, ValueKind kind, Value& keep) {
  if (!stream.peek().is(ElementKind::value)) return nullptr;
  const SourceSpan span = stream.peek().span;
  keep = stream.take_value();
  if (keep.kind() == kind) return &keep.as<Wanted>();
  stream.context().fail(span, fmt::format("expected {} or its items, found {}",
                                          kind == ValueKind::finish ? "a finish" : "a texture", describe(keep)));
}

}  // namespace

Pigment read_pigment(Context& context, const Element& block, const Pigment& base) {
  ElementStream stream(context, block);
  Pigment pigment = base;
  if (stream.peek().is(ElementKind::value)) {
    const Element first = stream.peek();
    const Value value = stream.take_value();
    if (value.kind() == ValueKind::pigment) {
      pigment = value.as<PigmentValue>().pigment;
    } else if (value.is_numeric() && first.node->kind != grammar::NodeKind::vector) {
      pigment.colour = to_colour(read_colour_after(stream, value));
    } else {
      context.fail(first.span, fmt::format("expected a pigment or colour, found {}", describe(value)),
                   value.is_numeric() ? "write `rgb` before it" : "");
    }
  }
  while (!stream.peek().is(ElementKind::end)) {
    const Element next = stream.peek();
    if (next.is(ElementKind::word) && is_colour_word(next.word)) {
      pigment.colour = read_colour(stream);
    } else if (next.is_word(word::kw_quick_color) || next.is_word(word::kw_quick_colour)) {
      stream.drop();
      static_cast<void>(read_colour(stream));  // for `--quality` below what a plain pigment distinguishes
    } else if (!read_transform(stream)) {      // a plain colour is the same everywhere
      static constexpr grammar::Symbol kKnown[] = {word::kw_color, word::kw_rgb, word::kw_srgb, word::kw_transmit};
      refuse(stream, kKnown);
    }
  }
  return pigment;
}

Finish read_finish(Context& context, const Element& block, const Finish& base) {
  ElementStream stream(context, block);
  Value keep;
  const auto* named = read_identifier<FinishValue>(stream, ValueKind::finish, keep);
  Finish finish = named ? named->finish : base;
  while (!stream.peek().is(ElementKind::end)) {
    if (read_finish_item(stream, finish)) continue;
    static constexpr grammar::Symbol kKnown[] = {word::kw_ambient,  word::kw_diffuse,    word::kw_brilliance,
                                                 word::kw_phong,    word::kw_phong_size, word::kw_specular,
                                                 word::kw_roughness};
    refuse(stream, kKnown);
  }
  return finish;
}

Texture read_texture(Context& context, const Element& block, const Texture& base) {
  ElementStream stream(context, block);
  Value keep;
  const auto* named = read_identifier<TextureValue>(stream, ValueKind::texture, keep);
  Texture texture = named ? named->texture : base;
  while (!stream.peek().is(ElementKind::end)) {
    if (stream.peek().is_block(word::kw_pigment)) {
      const Element pigment = stream.take();
      texture.pigment = read_pigment(context, pigment, texture.pigment);
    } else if (stream.peek().is_block(word::kw_finish)) {
      const Element finish = stream.take();
      texture.finish = read_finish(context, finish, texture.finish);
    } else if (!read_transform(stream)) {
      static constexpr grammar::Symbol kKnown[] = {word::kw_pigment, word::kw_finish};
      refuse(stream, kKnown);
    }
  }
  return texture;
}

Texture layered(Context& context, const Texture& top, SourceSpan span) {
  if (top.pigment.colour.filter != 0 || top.pigment.colour.transmit != 0)
    context.unsupported(span, "a layered texture");
  return top;
}

bool read_texture_modifier(ElementStream& stream, std::optional<Texture>& texture) {
  const Element& next = stream.peek();
  if (!next.is(ElementKind::block)) return false;
  Context& context = stream.context();
  const Texture& base = texture ? *texture : context.default_texture;
  if (next.word == word::kw_texture) {
    const Element block = stream.take();
    const Texture top = read_texture(context, block, context.default_texture);
    texture = texture ? layered(context, top, block.word_span) : top;
    return true;
  }
  if (next.word == word::kw_pigment) {
    const Element block = stream.take();
    const Pigment pigment = read_pigment(context, block, base.pigment);
    texture = Texture{pigment, base.finish};
    return true;
  }
  if (next.word == word::kw_finish) {
    const Element block = stream.take();
    const Finish finish = read_finish(context, block, base.finish);
    texture = Texture{base.pigment, finish};
    return true;
  }
  return false;
}

scene::TextureId texture_id(Context& context, const Texture& texture) {
  return scene::TextureId{context.texture_table.find_or_add(texture, context.database.textures)};
}

}  // namespace isl::interpreter
