// Objects: the table of their readers, and their common parts (an identifier to copy, modifiers, placement).
#pragma once

#include "interpreter/element_stream.h"

#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace isl::interpreter {

/// An object while its block is read.
struct ObjectDraft : Surface {
  scene::Object object{};
  std::vector<scene::Light> lights{};
  bool cutaway_textures = false;
  bool has_modifiers = false;  ///< geometry cannot follow modifiers
};

[[nodiscard]] bool is_object_word(grammar::Symbol word);
[[nodiscard]] std::span<const grammar::Symbol> object_words();

/// Calls `read`, which reads the rest of the stream. If a number there is infinite or not a number, reads on to the
/// end, so that directives are executed, and returns false: the object or component is left out, as POV-Ray meets none.
template <class Read>
[[nodiscard]] bool read_if_finite(ElementStream& stream, std::string_view what, Read read) {
  Context& context = stream.context();
  struct Restored {
    std::string_view& place;
    std::string_view before;
    ~Restored() { place = before; }
  } const restored{context.left_out, std::exchange(context.left_out, what)};
  try {
    read();
    return true;
  } catch (const LeftOut&) {
    stream.skip_rest();
    return false;
  }
}

/// Reads a whole block whose word is an object's.
[[nodiscard]] Ref<ObjectValue> read_object(Context& context, const Element& block);
/// The next element as an object, a value or a block; null if it is neither. An object of an unsupported kind is
/// reported and gives an empty one.
[[nodiscard]] Ref<ObjectValue> read_child(ElementStream& stream);
/// An empty object: a union without children, so that it may be used wherever an object is expected.
[[nodiscard]] Ref<ObjectValue> empty_object(ElementStream& stream);

/// Reads one modifier that every object takes (transform, texture, flag) into the draft; returns false if the next
/// element is none.
[[nodiscard]] bool read_object_modifier(ElementStream& stream, ObjectDraft& draft);
/// Reads modifiers up to the end of the block.
void read_object_modifiers(ElementStream& stream, ObjectDraft& draft);

/// The value as an object of a group or of the world, its texture in the database.
[[nodiscard]] scene::Object placed(Context& context, const ObjectValue& value);
/// Counts an object that a bare name places, and its lights, against the scene's limits.
void count_copy(Context& context, const ObjectValue& value, SourceSpan span);

/// Puts the group into the database and counts it.
[[nodiscard]] scene::GroupId add_group(ElementStream& stream, scene::Group group);
/// Does the same and makes the group the draft's shape.
void set_group(ElementStream& stream, ObjectDraft& draft, scene::Group group);

// ---- Readers of geometry, one a row of the table: each reads up to the first modifier -------------------------------

#define ISL_SOLID(word, ...) void read_##word(ElementStream& stream, ObjectDraft& draft);
#include "renderer/scene/solids.def"
void read_blob(ElementStream& stream, ObjectDraft& draft);
void read_csg(ElementStream& stream, ObjectDraft& draft);
void read_any_object(ElementStream& stream, ObjectDraft& draft);
void read_light_source(ElementStream& stream, ObjectDraft& draft);
void read_light_group(ElementStream& stream, ObjectDraft& draft);

/// Copies a declared object, for `sphere { Name … }` and `object { Name … }`.
void copy_object(ElementStream& stream, const ObjectValue& from, ObjectDraft& draft);

}  // namespace isl::interpreter
