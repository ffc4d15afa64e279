#include "interpreter/readers/objects/objects.h"

#include "interpreter/readers/textures/texture.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/supported.h"
#include "interpreter/records.h"

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
    {word::kw_blob, read_blob},
#define ISL_SOLID(solid, ...) {word::kw_##solid, read_##solid},
#include "renderer/scene/solids.def"
    {word::kw_union, read_csg},
    {word::kw_merge, read_csg},
    {word::kw_intersection, read_csg},
    {word::kw_difference, read_csg},
    {word::kw_composite, read_csg},
    {word::kw_object, read_any_object},
    {word::kw_light_source, read_light_source},
    {word::kw_light_group, read_light_group},
};

constexpr auto kObjectWords = [] {
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

/// Groups are shared, so the group of another name stays unchanged.
void cut_textures_away(ElementStream& stream, ObjectDraft& draft) {
  scene::Group group = stream.context().database.groups[draft.object.shape];
  group.cutaway_textures = true;
  set_group(stream, draft, std::move(group));
}

}  // namespace

bool is_object_word(grammar::Symbol name) { return find_reader(name) != nullptr; }

std::span<const grammar::Symbol> object_words() { return kObjectWords; }

scene::GroupId add_group(ElementStream& stream, scene::Group group) {
  Context& context = stream.context();
  context.count_primitive(stream.span(), kHeldWhileMoving * sizeof(scene::Group) +
                                             group.children.size() * sizeof(scene::Object) +
                                             group.lights.size() * sizeof(scene::Light) + kOriginBytes);
  context.database.groups.push_back(std::move(group));
  return scene::GroupId{static_cast<std::uint32_t>(context.database.groups.size() - 1)};
}

void set_group(ElementStream& stream, ObjectDraft& draft, scene::Group group) {
  draft.object.shape = index(add_group(stream, std::move(group)));
  draft.object.kind = scene::Object::Kind::group;
}

void count_copy(Context& context, const ObjectValue& value, SourceSpan span) {
  context.count_primitive(span, kHeldWhileMoving * sizeof(scene::Object) + kOriginBytes);
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

Ref<ObjectValue> read_object(Context& context, const Element& block) {
  const ObjectReader* reader = find_reader(block.word);
  ISL_CHECK(reader, "no reader of `{}`", context.text(block.word));
  ElementStream stream(context, block);
  ObjectDraft draft;
  draft.object.origin = context.origin(block.span);
  const bool is_finite = read_if_finite(stream, "the object", [&] {
    reader->read(stream, draft);
    read_object_modifiers(stream, draft);
  });
  if (!is_finite) return empty_object(stream);
  if (draft.cutaway_textures) cut_textures_away(stream, draft);
  Ref<ObjectValue> value = make_shared_value<ObjectValue>();
  value->word = block.word;
  value->object = draft.object;
  value->surface = static_cast<const Surface&>(draft);
  value->lights = std::move(draft.lights);
  return value;
}

Ref<ObjectValue> read_child(ElementStream& stream) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (next.is(ElementKind::block) && is_object_word(next.word)) {
    stream.drop();
    return read_object(context, next);
  }
  if (next.is(ElementKind::block) && is_unsupported_object(next.word)) {
    refuse(stream, {});
    return empty_object(stream);
  }
  if (!next.is(ElementKind::value)) return {};
  const Value value = stream.take_value();
  if (value.kind() != ValueKind::object) {
    context.fail(next.span, fmt::format("expected an object, found {}", describe(value)));
  }
  return Ref<ObjectValue>(&value.as<ObjectValue>());
}

Ref<ObjectValue> empty_object(ElementStream& stream) {
  Ref<ObjectValue> value = make_shared_value<ObjectValue>();
  value->object.kind = scene::Object::Kind::group;
  value->object.shape = index(add_group(stream, {}));
  value->object.origin = stream.context().origin(stream.span());
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
