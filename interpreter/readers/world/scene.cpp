#include "interpreter/readers/world/scene.h"

#include "interpreter/readers/objects/objects.h"
#include "interpreter/readers/textures/finish.h"
#include "interpreter/readers/textures/surface.h"
#include "interpreter/readers/textures/texture.h"
#include "interpreter/readers/view/camera.h"
#include "interpreter/readers/view/picture_shape.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/world/settings.h"
#include "interpreter/readers/world/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

void place(Context& context, const ObjectValue& value) {
  if (value.object.shape != scene::kNone) {
    scene::Object object = placed(context, value);
    if (object.texture == scene::kNoTexture && context.has_default_texture) {
      // The default texture is in world space, not in the object's.
      const scene::Transform& world_from_object = object.parent_from_object;
      object.texture = texture_id(context, moved(context, context.default_texture, world_from_object.inverted()));
    }
    context.database.objects.push_back(object);
  }
  context.database.lights.insert(context.database.lights.end(), value.lights.begin(), value.lights.end());
}

void set_camera(Context& context, const CameraValue& value, SourceSpan span) {
  if (context.database.camera) context.warn(span, "this camera replaces an earlier one");
  context.database.camera = value.camera;
  check_shape(context, value.camera, value.size_span);
}

void place_camera(Context& context, const Element& block) {
  set_camera(context, *read_camera(context, block), block.word_span);
}

void set_default(Context& context, const Element& block) { read_default(context, block.items, block.span); }

/// A block of the top level that is neither an object nor an effect's statement. Old scenes write `default` without its
/// `#`.
struct TopLevelBlock {
  grammar::Symbol word;
  void (*read)(Context&, const Element&);
};
constexpr TopLevelBlock kTopLevelBlocks[] = {
    {word::kw_camera, place_camera},
    {word::kw_background, read_background},
    {word::kw_global_settings, read_global_settings},
    {word::kw_default, set_default},
};

/// Returns false if the element is not a block of the top level.
bool read_top_level_block(ElementStream& stream) {
  const Element block = stream.peek();
  if (!block.is(ElementKind::block)) return false;
  Context& context = stream.context();
  if (is_object_word(block.word)) {
    stream.drop();
    place(context, *read_object(context, block));
  } else if (const auto* const row = std::ranges::find(kTopLevelBlocks, block.word, &TopLevelBlock::word);
             row != std::end(kTopLevelBlocks)) {
    stream.drop();
    row->read(context, block);
  } else if (statement_kind(context, block.word)) {
    stream.drop();
    place_statement(context, block);
  } else {
    return false;
  }
  return true;
}

void read_statement(ElementStream& stream) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (read_top_level_block(stream)) return;
  if (next.is(ElementKind::value)) {
    const Value value = stream.take_value();
    if (value.kind() != ValueKind::object) {
      context.fail(next.span, fmt::format("expected an object or a directive, found {}", describe(value)));
    }
    count_copy(context, value.as<ObjectValue>(), next.span);
    return place(context, value.as<ObjectValue>());
  }
  static constexpr auto kKnown = std::to_array<grammar::Symbol>(
      {word::kw_blob, word::kw_sphere, word::kw_cylinder, word::kw_cone, word::kw_plane, word::kw_union,
       word::kw_object, word::kw_light_source, word::kw_camera, word::kw_background, word::kw_global_settings});
  refuse(stream, kKnown);
}

}  // namespace

void read_scene(Context& context, const grammar::Unit& unit) {
  ElementStream stream(context, unit.items, unit.span);
  while (true) {
    try {
      if (stream.peek().is(ElementKind::end)) return;
      read_statement(stream);
    } catch (const Failed&) {
      stream.recover();
    }
  }
}

void read_default(Context& context, grammar::Items items, SourceSpan span) {
  ElementStream stream(context, items, span);
  Surface look;
  look.texture = context.default_texture;
  while (!stream.peek().is(ElementKind::end)) {
    const Element next = stream.peek();
    if (next.is_block(word::kw_camera)) {
      stream.drop();
      context.default_camera = read_camera(context, next);
    } else if (next.is_block(word::kw_texture)) {
      // The texture is not a layer: it replaces the default.
      stream.drop();
      look.texture = read_texture(context, next, context.default_texture);
      if (look.texture->pattern != scene::kNoTexturePattern || look.texture->below != scene::kNoTexture) {
        context.fail(next.word_span, "the default texture cannot have layers");
      }
    } else if (!read_texture_modifier(stream, look)) {
      static constexpr grammar::Symbol kKnown[] = {word::kw_texture, word::kw_pigment, word::kw_normal, word::kw_finish,
                                                   word::kw_camera};
      refuse(stream, kKnown);
    }
  }
  context.default_texture = *look.texture;
  context.has_default_texture = true;
  context.is_default_stated = true;
}

void follow_version(Context& context) {
  if (context.is_default_stated) return;
  context.has_default_texture = context.version.number() >= LanguageVersion::kWithNewerWords;
  context.default_texture = {};
  if (!context.has_default_texture) return;
  context.default_texture.pigment.colour = {1, 1, 1, 0, 0};
  scene::Finish finish;
  finish.ambient = {0, 0, 0, 0, 0};
  context.default_texture.finish = finish_id(context, finish);
}

}  // namespace isl::interpreter
