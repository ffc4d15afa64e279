// `union`, `intersection`, `difference`, `merge`, `light_group` and `object { … }`: objects made of others.
#include "interpreter/readers/objects/objects.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace isl::interpreter {
namespace {

using scene::Operation;
namespace word = grammar::word;

struct CsgWord {
  grammar::Symbol word;
  Operation operation;
};
constexpr CsgWord kCsgWords[] = {{word::kw_union, Operation::unite},
                                 {word::kw_composite, Operation::unite},
                                 {word::kw_merge, Operation::merge},
                                 {word::kw_intersection, Operation::intersect},
                                 {word::kw_difference, Operation::subtract}};

/// True if a lone name at the start of a block is copied: `union { Name … }` with a Name that is made of objects
/// itself. Any other object is the first child, and so is the empty object that replaces an unsupported one.
bool is_copy(const Element& element, const ObjectValue& value) {
  const bool is_group = value.object.kind == scene::Object::Kind::group && value.object.shape != scene::kNone;
  return element.is(ElementKind::value) && is_group && value.word != grammar::kNoSymbol;
}

/// Reads children up to the first modifier; returns true if the whole was copied from another group instead.
bool read_children(ElementStream& stream, ObjectDraft& draft, scene::Group& group, std::vector<scene::Light>& lights) {
  Context& context = stream.context();
  bool is_first = true;
  while (true) {
    const Element next = stream.peek();
    const Ref<ObjectValue> child = read_child(stream);
    if (!child) return false;
    if (is_first && is_copy(next, *child)) {
      copy_object(stream, *child, draft);
      return true;
    }
    is_first = false;
    if (next.is(ElementKind::value)) count_copy(context, *child, next.span);
    if (child->object.shape != scene::kNone) group.children.push_back(placed(context, *child));
    lights.insert(lights.end(), child->lights.begin(), child->lights.end());
  }
}

bool is_triangle(const Context& context, const scene::Object& object) {
  return object.kind == scene::Object::Kind::solid && scene::is_triangle(context.database.solids[object.shape].kind);
}

void check_children(ElementStream& stream, const scene::Group& group, std::size_t count) {
  Context& context = stream.context();
  const std::string_view name = context.text(stream.word());
  const bool needs_inside = group.operation == Operation::intersect || group.operation == Operation::subtract;
  // POV-Ray also warns of a union with one child; generated scenes have many, and their meaning is clear.
  if (count == 0) context.warn(stream.span(), fmt::format("this `{}` is empty", name));
  if (count == 1 && needs_inside)
    context.warn(stream.span(), fmt::format("`{}` needs two objects or more, found one", name));
  const auto is_light_group = [&](const scene::Object& child) {
    return child.kind == scene::Object::Kind::group && context.database.groups[child.shape].is_light_group;
  };
  if (group.operation != Operation::unite && std::ranges::any_of(group.children, is_light_group))
    context.warn(stream.span(), fmt::format("the lights of a `light_group` within `{}` do not shine", name),
                 fmt::format("put the `{}` into the `light_group`", name));
  if (!needs_inside) return;
  const auto has_no_inside = [&](const scene::Object& child) { return is_triangle(context, child); };
  if (std::ranges::any_of(group.children, has_no_inside))
    context.warn(stream.span(), fmt::format("a triangle has no inside, which `{}` needs", name));
}

/// Fails if an object follows the modifiers of a group.
void refuse_late_child(ElementStream& stream) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (!next.is(ElementKind::block) || !is_object_word(next.word)) return;
  context.fail(next.word_span,
               fmt::format("found `{}` after a modifier of the `{}`, expected another modifier",
                           context.text(next.word), context.text(stream.word())),
               "put the objects of a group before its modifiers");
}

}  // namespace

void read_csg(ElementStream& stream, ObjectDraft& draft) {
  const auto* const row = std::ranges::find(kCsgWords, stream.word(), &CsgWord::word);
  ISL_CHECK(row != std::end(kCsgWords));
  scene::Group group{.operation = row->operation};
  while (!stream.peek().is(ElementKind::end)) {
    if (!draft.has_modifiers && read_children(stream, draft, group, draft.lights)) return;
    if (stream.peek().is(ElementKind::end)) break;
    if (read_object_modifier(stream, draft)) continue;
    if (draft.has_modifiers) refuse_late_child(stream);
    refuse(stream, object_words());
  }
  check_children(stream, group, group.children.size() + draft.lights.size());
  set_group(stream, draft, std::move(group));
}

void read_light_group(ElementStream& stream, ObjectDraft& draft) {
  scene::Group group{.is_light_group = true};
  if (read_children(stream, draft, group, group.lights)) return;
  scene::Transform parent_from_object;
  while (!stream.peek().is(ElementKind::end)) {
    const SourceSpan span = stream.peek().span;
    if (const std::optional<scene::Transform> transform = read_transform(stream)) {
      parent_from_object = then_placed(stream.context(), span, parent_from_object, *transform);
    } else if (stream.peek().is_word(word::kw_global_lights)) {
      stream.drop();
      group.global_lights = read_optional_truth(stream);
    } else if (const Ref<ObjectValue> child = read_child(stream)) {
      stream.context().fail(stream.span(), "put the objects of a `light_group` before its modifiers");
    } else {
      refuse(stream, object_words());
    }
  }
  set_group(stream, draft, std::move(group));
  draft.object.parent_from_object = parent_from_object;
}

void read_any_object(ElementStream& stream, ObjectDraft& draft) {
  const Ref<ObjectValue> child = read_child(stream);
  if (!child) fail_expected(stream, "an object");
  copy_object(stream, *child, draft);
}

}  // namespace isl::interpreter
