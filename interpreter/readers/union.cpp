// `union { … }` and `object { … }`.
#include "interpreter/readers/arguments.h"
#include "interpreter/readers/objects.h"

#include <fmt/format.h>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

void add_child(Context& context, const ObjectValue& value, scene::Group& group, ObjectDraft& draft) {
  if (value.object.shape != scene::kNone) group.children.push_back(placed(context, value));
  draft.lights.insert(draft.lights.end(), value.lights.begin(), value.lights.end());
}

/// An object as a value or a block; null where the next element is neither.
Ref<ObjectValue> read_child(ElementStream& stream) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (next.is(ElementKind::block) && is_object_word(next.word)) {
    stream.drop();
    return read_object(context, next);
  }
  if (!next.is(ElementKind::value)) return {};
  const Value value = stream.take_value();
  if (value.kind() != ValueKind::object) {
    context.fail(next.span, fmt::format("expected an object, found {}", describe(value)));
  }
  return Ref<ObjectValue>(&value.as<ObjectValue>());
}

}  // namespace

void read_union(ElementStream& stream, ObjectDraft& draft) {
  Context& context = stream.context();
  scene::Group group;
  bool is_first = true;
  while (!stream.peek().is(ElementKind::end) && !draft.has_modifiers) {
    const Element next = stream.peek();
    const Ref<ObjectValue> child = read_child(stream);
    if (child) {
      // `union { Name … }` copies a union that was declared; any other object is its first child.
      if (is_first && child->word == word::kw_union && next.is(ElementKind::value))
        return copy_object(stream, *child, draft);
      if (next.is(ElementKind::value)) count_copy(context, *child, next.span);
      add_child(context, *child, group, draft);
      is_first = false;
    } else if (next.is_word(word::kw_split_union)) {
      stream.drop();
      static_cast<void>(read_optional_truth(stream));
    } else if (!read_object_modifier(stream, draft)) {
      refuse(stream, object_words());
    }
  }
  context.count_primitive(stream.span(),
                          sizeof(scene::Group) + group.children.size() * sizeof(scene::Object) + kOriginBytes);
  draft.object.kind = scene::Object::Kind::group;
  draft.object.shape = static_cast<std::uint32_t>(context.database.groups.size());
  context.database.groups.push_back(std::move(group));
}

void read_any_object(ElementStream& stream, ObjectDraft& draft) {
  const Ref<ObjectValue> child = read_child(stream);
  if (!child && stream.peek().is(ElementKind::block)) return refuse(stream, object_words());
  if (!child) fail_expected(stream, "an object");
  copy_object(stream, *child, draft);
}

}  // namespace isl::interpreter
