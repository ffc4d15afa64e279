// The modifiers of every object, after its geometry: transforms, textures, flags, clipped_by, bounded_by.
#include "interpreter/readers/objects/objects.h"
#include "interpreter/readers/textures/surface.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/colour.h"
#include "interpreter/readers/words/said_at.h"
#include "interpreter/readers/words/transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

namespace isl::interpreter {
namespace {

using scene::Object;
using scene::ObjectItem;
namespace word = grammar::word;

void move(Context& context, SourceSpan span, ObjectDraft& draft, const scene::Transform& transform) {
  draft.object.parent_from_object = then_placed(context, span, draft.object.parent_from_object, transform);
  for (scene::Light& light : draft.lights) scene::move(light, transform);
}

// ---- Flags ----------------------------------------------------------------------------------------------------------

struct Flag {
  grammar::Symbol word;
  bool Object::*member;
};

/// As in POV-Ray, these flags can be set but not cleared; only `hollow` has a truth value.
constexpr Flag kObjectFlags[] = {{word::kw_no_shadow, &Object::no_shadow},
                                 {word::kw_no_image, &Object::no_image},
                                 {word::kw_no_reflection, &Object::no_reflection},
                                 {word::kw_no_radiosity, &Object::no_radiosity},
                                 {word::kw_double_illuminate, &Object::double_illuminate}};

constexpr ItemWord<ObjectItem> kObjectPlaces[] = {{word::kw_no_image, ObjectItem::no_image},
                                                  {word::kw_no_reflection, ObjectItem::no_reflection},
                                                  {word::kw_double_illuminate, ObjectItem::double_illuminate},
                                                  {word::kw_interior_texture, ObjectItem::interior_texture}};

bool read_flag(ElementStream& stream, ObjectDraft& draft) {
  const grammar::Symbol name = stream.peek().word;
  if (const auto* const flag = std::ranges::find(kObjectFlags, name, &Flag::word); flag != std::end(kObjectFlags)) {
    stream.drop();
    draft.object.*flag->member = true;
    return true;
  }
  if (name == word::kw_hollow) {
    stream.drop();
    draft.object.hollow = read_optional_truth(stream);
    return true;
  }
  if (name == word::kw_inverse) {  // two inversions cancel out
    stream.drop();
    draft.object.inverse = !draft.object.inverse;
    return true;
  }
  return false;
}

// ---- Words that only some objects accept --------------------------------------------------------------------------

const scene::Group* group_of(const ElementStream& stream, const ObjectDraft& draft) {
  const bool is_group = draft.object.kind == Object::Kind::group && draft.object.shape != scene::kNone;
  return is_group ? &stream.context().database.groups[draft.object.shape] : nullptr;
}

/// True if POV-Ray finds the object's surface by solving polynomials, so that it takes `sturm`.
bool takes_sturm(const ElementStream& stream, const ObjectDraft& draft) {
  if (draft.object.kind == Object::Kind::blob) return true;
  // A spindle torus is a group of its parts.
  if (stream.word() == word::kw_torus) return true;
  if (draft.object.kind != Object::Kind::solid || draft.object.shape == scene::kNone) return false;
  return scene::traits_of(stream.context().database.solids[draft.object.shape].kind).takes_sturm;
}

bool takes_cutaway_textures(const ElementStream& stream, const ObjectDraft& draft) {
  // While the children of a block are read, the block's word tells the kind of group.
  const scene::Group* const group = group_of(stream, draft);
  if (!group) return stream.word() == word::kw_intersection || stream.word() == word::kw_difference;
  return group->operation == scene::Operation::intersect || group->operation == scene::Operation::subtract;
}

/// Words without an effect on our pictures: hints for POV-Ray's root finders.
bool read_hint(ElementStream& stream, const ObjectDraft& draft) {
  const grammar::Symbol name = stream.peek().word;
  const bool is_blob = draft.object.kind == Object::Kind::blob;
  const bool is_hint = (name == word::kw_sturm && takes_sturm(stream, draft)) ||
                       (name == word::kw_hierarchy && is_blob) || name == word::kw_split_union;
  if (!is_hint) return false;
  stream.drop();
  static_cast<void>(read_optional_truth(stream));
  return true;
}

bool read_cutaway_textures(ElementStream& stream, ObjectDraft& draft) {
  if (!stream.peek().is_word(word::kw_cutaway_textures)) return false;
  if (!takes_cutaway_textures(stream, draft)) {
    stream.context().fail(stream.peek().span, "`cutaway_textures` is allowed only in an intersection or difference");
  }
  stream.drop();
  return draft.cutaway_textures = true;
}

// ---- clipped_by and bounded_by --------------------------------------------------------------------------------------

/// Reads the rest of a block: objects, and transforms behind them that move all of them.
std::vector<Object> read_moved_objects(ElementStream& stream) {
  Context& context = stream.context();
  std::vector<Object> objects;
  bool is_empty = true;
  for (Element next = stream.peek(); const Ref<ObjectValue> object = read_child(stream); next = stream.peek()) {
    if (next.is(ElementKind::value)) count_copy(context, *object, next.span);
    if (object->object.shape != scene::kNone) objects.push_back(placed(context, *object));
    is_empty = false;
  }
  if (is_empty) fail_expected(stream, "an object");
  scene::Transform moved;
  std::string_view expected = "an object or a transform";
  while (!stream.peek().is(ElementKind::end)) {
    const SourceSpan span = stream.peek().span;
    const std::optional<scene::Transform> transform = read_transform(stream);
    if (!transform) fail_expected(stream, expected);
    moved = then_placed(context, span, moved, *transform);
    expected = "a transform";
  }
  for (Object& object : objects) object.parent_from_object = scene::then(object.parent_from_object, moved);
  return objects;
}

/// `clipped_by { Object… }` adds to the present clipping objects; `clipped_by { bounded_by }` clips by the bounding
/// ones. `bounded_by` works in the same way.
void read_clip(ElementStream& stream, const ObjectDraft& draft, scene::GroupId& clip, scene::GroupId other,
               grammar::Symbol other_word) {
  Context& context = stream.context();
  const Element block = stream.take();
  ElementStream inner(context, block);
  if (inner.peek().is_word(other_word)) {
    inner.drop();
    expect_end(inner);
    if (other == scene::kNoGroup) {
      context.warn(block.span, fmt::format("the object has no `{}` before this", context.text(other_word)));
    } else {
      clip = other;
    }
    return;
  }
  scene::Group group{.operation = scene::Operation::intersect};
  if (clip != scene::kNoGroup) group.children = context.database.groups[index(clip)].children;
  const scene::Transform object_from_parent = draft.object.parent_from_object.inverted();
  for (Object& object : read_moved_objects(inner)) {
    object.parent_from_object = scene::then(object.parent_from_object, object_from_parent);
    group.children.push_back(object);
  }
  clip = add_group(inner, std::move(group));
}

bool read_clips(ElementStream& stream, ObjectDraft& draft) {
  Object& object = draft.object;
  if (stream.peek().is_block(word::kw_clipped_by)) {
    read_clip(stream, draft, object.clip, object.bound, word::kw_bounded_by);
    return true;
  }
  if (stream.peek().is_block(word::kw_bounded_by)) {
    read_clip(stream, draft, object.bound, object.clip, word::kw_clipped_by);
    return true;
  }
  return false;
}

/// POV-Ray reads a colour directly in an object, and ignores it.
bool read_stray_colour(ElementStream& stream) {
  const Element next = stream.peek();
  if (!is_colour_word(next.word)) return false;
  static_cast<void>(read_colour(stream));
  stream.context().warn(next.span, "a colour is not a modifier of an object and has no effect here",
                        "write `pigment { … }` around it");
  return true;
}

bool read_modifier(ElementStream& stream, ObjectDraft& draft) {
  const SourceSpan span = stream.peek().span;
  if (const std::optional<scene::Transform> transform = read_transform(stream)) {
    move(stream.context(), span, draft, *transform);
    return true;
  }
  note_place(stream.context(), stream.peek(), kObjectPlaces, draft.object.said_at);
  if (read_surface_modifier(stream, draft, draft.object.parent_from_object)) return true;
  if (stream.peek().is(ElementKind::block)) return read_clips(stream, draft);
  if (!stream.peek().is(ElementKind::word)) return false;
  return read_stray_colour(stream) || read_flag(stream, draft) || read_hint(stream, draft) ||
         read_cutaway_textures(stream, draft);
}

}  // namespace

bool read_object_modifier(ElementStream& stream, ObjectDraft& draft) {
  const bool was_read = read_modifier(stream, draft);
  draft.has_modifiers |= was_read;
  return was_read;
}

void read_object_modifiers(ElementStream& stream, ObjectDraft& draft) {
  while (!stream.peek().is(ElementKind::end)) {
    if (read_object_modifier(stream, draft)) continue;
    static constexpr grammar::Symbol kKnown[] = {
        word::kw_translate, word::kw_rotate,    word::kw_scale,      word::kw_matrix,           word::kw_transform,
        word::kw_texture,   word::kw_pigment,   word::kw_normal,     word::kw_finish,           word::kw_material,
        word::kw_interior,  word::kw_no_shadow, word::kw_no_image,   word::kw_clipped_by,       word::kw_no_reflection,
        word::kw_hollow,    word::kw_inverse,   word::kw_bounded_by, word::kw_double_illuminate};
    refuse(stream, kKnown);
  }
}

}  // namespace isl::interpreter
