// Patterns as pigments, normals and textures hold them: their words, blocks and operands, which the descriptors of
// their kinds declare (renderer/patterns/kinds/), and the modifiers that every pattern takes. Knows nothing of what a
// pattern chooses from: the host reads its maps and lists.
#pragma once

#include "interpreter/element_stream.h"
#include "renderer/patterns/kinds/pattern_kind.h"

#include <functional>
#include <span>
#include <string_view>

namespace isl::interpreter {

/// The block that holds the pattern. It decides which patterns may stand there and what follows them.
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

/// Makes it a pattern of the kind, with the kind's defaults.
void set_kind(PatternDraft& draft, scene::PatternKind kind);

/// Reads the list of items that belongs to a block pattern (`checker A, B`), at most `count`. Empty if there is
/// none.
using ReadList = std::function<void(ElementStream& stream, scene::PatternKind kind, int count)>;

/// The next thing is a pattern's word or block.
[[nodiscard]] bool starts_pattern(Context& context, const Element& element);

/// Reads a pattern's word or block with its operands into the draft, if the next element is one.
[[nodiscard]] bool read_pattern(ElementStream& stream, PatternDraft& draft, PatternHost host,
                                const ReadList& read_list);

/// `pattern { … }` as the body of a function: a pattern of points, with its modifiers.
[[nodiscard]] scene::Pattern read_pattern_block(Context& context, const Element& block);

/// The number of items in the pattern's list; 0 for one that has no list.
[[nodiscard]] inline int list_length(scene::PatternKind kind) { return render::info_of(kind).list_length; }
/// The words that begin a pattern of the kind.
[[nodiscard]] std::span<const std::string_view> words_of(scene::PatternKind kind);
/// The first of these words.
[[nodiscard]] std::string_view name_of(scene::PatternKind kind);

/// Reads a transform, warp, wave, turbulence or other modifier of any pattern, if the next element is one.
[[nodiscard]] bool read_pattern_modifier(ElementStream& stream, PatternDraft& draft);

/// Moves the pattern; a pattern that is evaluated at (u, v) of the surface stays.
void move(Context& context, PatternDraft& draft, const scene::Transform& transform);

}  // namespace isl::interpreter
