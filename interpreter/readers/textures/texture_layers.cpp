// Operations on whole textures, layer by layer: laying one over another, moving, mapping.
#include "interpreter/readers/patterns/pattern.h"
#include "interpreter/readers/textures/finish.h"
#include "interpreter/readers/textures/normal.h"
#include "interpreter/readers/textures/texture.h"
#include "interpreter/records.h"

namespace isl::interpreter {
namespace {

using scene::Texture;
using scene::TexturePattern;

scene::TexturePatternId add_pattern(Context& context, TexturePattern&& record) {
  return add_record<scene::TexturePatternId>(context, context.database.texture_patterns, std::move(record));
}

/// Applies `change` to the texture and every layer under it, and lays the lowest over `below`.
template <class Change>
Texture each_layer(Context& context, const Texture& top, Change change, scene::TextureId below = scene::kNoTexture) {
  std::vector<Texture> layers{top};
  while (layers.back().below != scene::kNoTexture)
    layers.push_back(context.database.textures[index(layers.back().below)]);
  for (std::size_t i = layers.size(); i-- > 0;) {
    change(layers[i]);
    layers[i].below = below;
    if (i > 0) below = texture_id(context, layers[i]);
  }
  return layers.front();
}

/// True if the texture hides everything below it.
bool is_opaque(const Context& context, Texture layer) {
  while (layer.below != scene::kNoTexture) layer = context.database.textures[index(layer.below)];
  return layer.pigment.is_plain() && layer.pigment.colour.filter == 0 && layer.pigment.colour.transmit == 0;
}

}  // namespace

Texture layered(Context& context, const Texture& below, const Texture& top, SourceSpan span) {
  if (below.pattern != scene::kNoTexturePattern || top.pattern != scene::kNoTexturePattern) {
    context.fail(span, "a texture with a pattern cannot be a layer");
  }
  if (is_opaque(context, top)) return top;
  return each_layer(
      context, top, [](Texture& /*layer*/) {}, texture_id(context, below));
}

Texture without_bump_scale(Context& context, const Texture& texture) {
  return each_layer(context, texture,
                    [&context](Texture& layer) { layer.normal = without_bump_scale(context, layer.normal); });
}

Texture uv_mapped(Context& context, const Texture& texture) {
  return each_layer(context, texture, [&context](Texture& layer) {
    layer.uv_mapping = 1;
    if (layer.pattern == scene::kNoTexturePattern) return;
    TexturePattern record = context.database.texture_patterns[index(layer.pattern)];
    record.pattern.uv_mapping = true;
    layer.pattern = add_pattern(context, std::move(record));
  });
}

Texture moved(Context& context, const Texture& texture, const scene::Transform& transform) {
  if (texture.is_plain() || transform == scene::Transform()) return texture;
  return each_layer(context, texture, [&](Texture& layer) {
    if (layer.uv_mapping != 0) return;
    layer.pigment = moved(context, layer.pigment, transform);
    layer.normal = moved(context, layer.normal, transform);
    if (layer.pattern == scene::kNoTexturePattern) return;
    TexturePattern record = context.database.texture_patterns[index(layer.pattern)];
    if (record.pattern.uv_mapping) return;
    PatternDraft draft = draft_of(context, record.pattern);
    move(context, draft, transform);
    record.pattern = std::move(draft.pattern);
    layer.pattern = add_pattern(context, std::move(record));
  });
}

scene::TextureId texture_id(Context& context, const Texture& texture) {
  return share_record<scene::TextureId>(context, context.texture_table, context.database.textures, texture);
}

}  // namespace isl::interpreter
