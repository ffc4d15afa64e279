// Patterns as pigments, normals and textures hold them: the table of their words, and the modifiers that every pattern
// takes. Knows nothing of maps and lists: the host reads them.
#pragma once

#include "interpreter/element_stream.h"

#include <functional>

namespace isl::interpreter {

/// The construct that holds the pattern: it decides which patterns are allowed and what may follow them.
enum class PatternHost { pigment, normal, texture, function };

/// A pattern while its block is read.
struct PatternDraft {
  scene::Pattern pattern;
  /// The transforms at the end of `pattern.warps` that have this number or a greater one in the database belong to this
  /// draft alone and may be changed.
  std::size_t first_own_transform = 0;
};

/// A draft that starts from `pattern`.
[[nodiscard]] PatternDraft draft_of(Context& context, const scene::Pattern& pattern);

/// Reads the list of items that belongs to a block pattern (`checker A, B`), at most `count`. Empty if there is none.
using ReadList = std::function<void(ElementStream& stream, scene::PatternKind kind, int count)>;

/// True if the next element is a pattern's word or block.
[[nodiscard]] bool starts_pattern(const Element& element);

/// Reads a pattern's word or block with its operands into the draft, if the next element is one.
[[nodiscard]] bool read_pattern(ElementStream& stream, PatternDraft& draft, PatternHost host,
                                const ReadList& read_list);

/// `pattern { … }` as the body of a function: a pattern of points, with its modifiers.
[[nodiscard]] scene::Pattern read_pattern_block(Context& context, const Element& block);

/// The number of items that a block pattern chooses from (checker 2, hexagon 3 …); 0 for a pattern that takes a map.
[[nodiscard]] int list_length(scene::PatternKind kind);
/// The pattern's word in the language.
[[nodiscard]] std::string_view name_of(Context& context, scene::PatternKind kind);

/// Reads a transform, warp, wave, turbulence or other modifier of any pattern, if the next element is one.
[[nodiscard]] bool read_pattern_modifier(ElementStream& stream, PatternDraft& draft);

/// Moves the pattern; a pattern that is evaluated at (u, v) of the surface stays.
void move(Context& context, PatternDraft& draft, const scene::Transform& transform);

}  // namespace isl::interpreter
