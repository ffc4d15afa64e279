#include "interpreter/readers/objects.h"

#include "interpreter/readers/arguments.h"
#include "interpreter/readers/surface.h"
#include "interpreter/readers/texture.h"
#include "interpreter/readers/transform.h"

#include <fmt/format.h>

#include <array>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

struct ObjectReader {
  grammar::Symbol word;
  void (*read)(ElementStream&, ObjectDraft&);
};

constexpr ObjectReader kReaders[] = {
    {word::kw_blob, read_blob},         {word::kw_sphere, read_sphere},
    {word::kw_cylinder, read_cylinder}, {word::kw_cone, read_cone},
    {word::kw_plane, read_plane},       {word::kw_union, read_union},
    {word::kw_object, read_any_object}, {word::kw_light_source, read_light_source},
};

constexpr auto kWords = [] {
  std::array<grammar::Symbol, std::size(kReaders)> words{};
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = kReaders[i].word;
  return words;
}();

const ObjectReader* find_reader(grammar::Symbol name) {
  for (const ObjectReader& reader : kReaders) {
    if (reader.word == name) return &reader;
  }
  return nullptr;
}

void move(ObjectDraft& draft, const scene::Transform& transform) {
  draft.object.parent_from_object = scene::then(draft.object.parent_from_object, transform);
  for (scene::Light& light : draft.lights) light.location = transform.point(light.location);
}

/// Flags that change nothing in what is supported: without media, a solid's inside does not show, and without CSG its
/// inverse has the same surface.
bool is_flag_without_effect(grammar::Symbol name) {
  return name == word::kw_hollow || name == word::kw_inverse || name == word::kw_sturm || name == word::kw_hierarchy;
}

}  // namespace

bool is_object_word(grammar::Symbol name) { return find_reader(name) != nullptr; }

std::span<const grammar::Symbol> object_words() { return kWords; }

void count_copy(Context& context, const ObjectValue& value, SourceSpan span) {
  context.count_primitive(span, sizeof(scene::Object) + kOriginBytes);
  for (std::size_t i = 0; i < value.lights.size(); ++i) context.count_primitive(span, sizeof(scene::Light));
}

void copy_object(ElementStream& stream, const ObjectValue& from, ObjectDraft& draft) {
  count_copy(stream.context(), from, stream.span());
  const OriginId origin = draft.object.origin;
  draft.object = from.object;
  draft.object.origin = origin;
  static_cast<Surface&>(draft) = from.surface;
  draft.lights = from.lights;
  for (scene::Light& light : draft.lights) light.origin = origin;
}

bool read_object_modifier(ElementStream& stream, ObjectDraft& draft) {
  if (const std::optional<scene::Transform> transform = read_transform(stream)) {
    move(draft, *transform);
    return draft.has_modifiers = true;
  }
  if (read_surface_modifier(stream, draft, draft.object.parent_from_object)) return draft.has_modifiers = true;
  const Element next = stream.peek();
  if (next.is_word(word::kw_no_shadow)) {
    stream.drop();
    draft.object.no_shadow = true;
    return draft.has_modifiers = true;
  }
  if (next.is(ElementKind::word) && is_flag_without_effect(next.word)) {
    stream.drop();
    static_cast<void>(read_optional_truth(stream));
    return draft.has_modifiers = true;
  }
  if (next.is_block(word::kw_bounded_by)) {  // a promise that needs no keeping
    stream.drop();
    return draft.has_modifiers = true;
  }
  return false;
}

void read_object_modifiers(ElementStream& stream, ObjectDraft& draft) {
  while (!stream.peek().is(ElementKind::end)) {
    if (read_object_modifier(stream, draft)) continue;
    static constexpr grammar::Symbol kKnown[] = {word::kw_translate, word::kw_rotate,    word::kw_scale,
                                                 word::kw_matrix,    word::kw_transform, word::kw_texture,
                                                 word::kw_pigment,   word::kw_finish,    word::kw_no_shadow};
    refuse(stream, kKnown);
  }
}

Ref<ObjectValue> read_object(Context& context, const Element& block) {
  const ObjectReader* reader = find_reader(block.word);
  ISL_CHECK(reader, "no reader of `{}`", context.text(block.word));
  ElementStream stream(context, block);
  ObjectDraft draft;
  draft.object.origin = context.origin(block.span);
  reader->read(stream, draft);
  read_object_modifiers(stream, draft);
  Ref<ObjectValue> value = make_shared_value<ObjectValue>();
  value->word = block.word;
  value->object = draft.object;
  value->surface = draft;
  value->lights = std::move(draft.lights);
  return value;
}

scene::Object placed(Context& context, const ObjectValue& value) {
  scene::Object object = value.object;
  const Surface& surface = value.surface;
  if (surface.texture) object.texture = texture_id(context, *surface.texture);
  if (surface.interior_texture) object.interior_texture = texture_id(context, *surface.interior_texture);
  if (surface.interior != scene::kNoInterior) object.interior = surface.interior;
  return object;
}

}  // namespace isl::interpreter
