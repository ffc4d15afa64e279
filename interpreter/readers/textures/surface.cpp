#include "interpreter/readers/textures/surface.h"

#include "interpreter/readers/textures/finish.h"
#include "interpreter/readers/textures/interior.h"
#include "interpreter/readers/textures/normal.h"
#include "interpreter/readers/textures/pigment.h"
#include "interpreter/readers/textures/texture.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/transform.h"

#include <fmt/format.h>

namespace isl::interpreter {
namespace {

using scene::Texture;
using scene::Transform;
namespace word = grammar::word;

/// Transforms a value back from the object's present place into the object's own space.
template <class Moved>
Moved taken_back(Context& context, const Moved& what, const Transform& parent_from_object) {
  return moved(context, what, parent_from_object.inverted());
}

void add_layer(Context& context, std::optional<Texture>& texture, const Texture& top, SourceSpan span) {
  texture = texture ? layered(context, *texture, top, span) : top;
}

/// Keeps, in the object's space, how its pigment was moved while it was a plain colour. `plain_moved` is how it looks
/// at the object's present place.
void keep_moved(Surface& surface, const Transform& plain_moved, const Transform& space) {
  const bool is_unmoved = plain_moved == space;
  surface.plain_moved = is_unmoved ? nullptr : std::make_shared<const Transform>(then(plain_moved, space.inverted()));
}

/// pigment, normal and finish change the topmost layer, as it looks at the object's present place.
void read_part(Context& context, const Element& block, Surface& surface, const Transform& space) {
  const bool is_own = surface.texture.has_value();
  Texture top = surface.texture.value_or(context.default_texture);
  if (top.pattern != scene::kNoTexturePattern) {
    context.fail(block.word_span,
                 fmt::format("`{}` cannot be used with a texture that has a pattern", context.text(block.word)));
  }
  if (block.word == word::kw_pigment) {
    Transform plain_moved;
    if (is_own) plain_moved = surface.plain_moved ? then(*surface.plain_moved, space) : space;
    const scene::Pigment base = is_own ? moved(context, top.pigment, space) : top.pigment;
    const scene::Pigment pigment = read_pigment(context, block, base, plain_moved);
    top.pigment = pigment.is_plain() ? pigment : taken_back(context, pigment, space);
    keep_moved(surface, plain_moved, space);
  } else {
    if (block.word == word::kw_normal) {
      const scene::NormalId base = is_own ? moved(context, top.normal, space) : top.normal;
      top.normal = taken_back(context, read_normal(context, block, base), space);
    } else {
      top.finish = finish_id(context, read_finish(context, block, finish_of(context, top)));
    }
    if (!is_own) keep_moved(surface, {}, space);
  }
  surface.texture = top;
}

/// POV-Ray 3.0 had the ior in the finish; an object without an interior gets one from there.
void take_old_interior(Context& context, Surface& surface) {
  if (!surface.texture || surface.texture->finish == scene::kDefaultFinish) return;
  if (surface.interior != scene::kNoInterior) return;
  const scene::Finish& finish = context.database.finishes[index(surface.texture->finish)];
  if (finish.old_ior == 0 && finish.old_caustics == 0) return;
  scene::Interior interior;
  if (finish.old_ior != 0) interior.ior = finish.old_ior;
  interior.caustics = finish.old_caustics;
  surface.interior = interior_id(context, interior);
}

/// The material's texture is laid over the object's; its interior replaces the object's.
void apply(Context& context, const Surface& material, Surface& surface, const Transform& space, SourceSpan span) {
  if (material.texture) {
    add_layer(context, surface.texture, taken_back(context, *material.texture, space), span);
    keep_moved(surface, {}, space);
  }
  if (material.interior_texture) {
    add_layer(context, surface.interior_texture, taken_back(context, *material.interior_texture, space), span);
  }
  if (material.interior != scene::kNoInterior) surface.interior = material.interior;
}

bool read_material_item(ElementStream& stream, Surface& surface) {
  Context& context = stream.context();
  if (const std::optional<Transform> transform = read_transform(stream)) {
    if (surface.texture) surface.texture = moved(context, *surface.texture, *transform);
    if (surface.interior_texture) surface.interior_texture = moved(context, *surface.interior_texture, *transform);
    return true;
  }
  const Element next = stream.peek();
  const bool is_item =
      next.is_block(word::kw_texture) || next.is_block(word::kw_interior) || next.is_block(word::kw_interior_texture);
  return is_item && read_surface_modifier(stream, surface);
}

void read_interior_texture(Context& context, const Element& block, Surface& surface, const Transform& space) {
  if (!surface.texture) context.fail(block.word_span, "an `interior_texture` needs a `texture` before it");
  const Texture top = read_texture(context, block, context.default_texture);
  add_layer(context, surface.interior_texture, taken_back(context, top, space), block.word_span);
}

}  // namespace

bool read_texture_modifier(ElementStream& stream, Surface& surface, const Transform& space) {
  const Element& next = stream.peek();
  if (!next.is(ElementKind::block)) return false;
  Context& context = stream.context();
  if (next.word == word::kw_texture) {
    const Element block = stream.take();
    Transform plain_moved;
    const Texture top = read_texture(context, block, context.default_texture, plain_moved);
    add_layer(context, surface.texture, top.is_plain() ? top : taken_back(context, top, space), block.word_span);
    keep_moved(surface, plain_moved, space);
    return true;
  }
  if (next.word == word::kw_pigment || next.word == word::kw_normal || next.word == word::kw_finish) {
    const Element block = stream.take();
    read_part(context, block, surface, space);
    return true;
  }
  return false;
}

bool read_surface_modifier(ElementStream& stream, Surface& surface, const Transform& space) {
  Context& context = stream.context();
  if (stream.peek().is_word(word::kw_uv_mapping)) {
    if (surface.texture) context.fail(stream.peek().span, "put `uv_mapping` before the textures of an object");
    stream.drop();
    return surface.uv_mapping = true;
  }
  if (!stream.peek().is(ElementKind::block)) return false;
  if (read_texture_modifier(stream, surface, surface.uv_mapping ? Transform() : space)) {
    if (surface.uv_mapping) surface.texture = uv_mapped(context, *surface.texture);
    take_old_interior(context, surface);
    return true;
  }
  const Element block = stream.peek();
  if (block.word == word::kw_interior) {
    stream.drop();
    surface.interior = read_interior(context, block);
    return true;
  }
  if (block.word == word::kw_interior_texture) {
    stream.drop();
    read_interior_texture(context, block, surface, space);
    return true;
  }
  if (block.word == word::kw_material) {
    stream.drop();
    apply(context, read_material(context, block), surface, space, block.word_span);
    return true;
  }
  return false;
}

Surface read_material(Context& context, const Element& block) {
  ElementStream stream(context, block);
  Surface surface;
  if (stream.peek().is(ElementKind::value)) {
    const SourceSpan span = stream.peek().span;
    const Value value = stream.take_value();
    if (value.kind() != ValueKind::material)
      context.fail(span, fmt::format("expected a material or its items, found {}", describe(value)));
    surface = value.as<MaterialValue>().surface;
  }
  while (!stream.peek().is(ElementKind::end)) {
    if (read_material_item(stream, surface)) continue;
    static constexpr grammar::Symbol kKnown[] = {word::kw_texture, word::kw_interior, word::kw_interior_texture,
                                                 word::kw_scale,   word::kw_rotate,   word::kw_translate};
    refuse(stream, kKnown);
  }
  return surface;
}

}  // namespace isl::interpreter
