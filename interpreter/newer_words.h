// The words of POV-Ray 3.8 (grammar/newer_words.def) where they have their meaning: under every version, unless the
// scene declares the name. A scene that says it is older gets a remark once for each word.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

/// Remarks that the word at `span` came with 3.8, unless the scene is of that version or was told before.
void note_newer_word(Context& context, grammar::Symbol word, SourceSpan span);

/// True for the words that are values: `tau` and, without braces, `dictionary`.
[[nodiscard]] constexpr bool is_newer_value(grammar::Symbol word) {
  return word == grammar::newer_word::kw_tau || word == grammar::newer_word::kw_dictionary;
}
/// The value of such a word.
[[nodiscard]] Value newer_value(Context& context, grammar::Symbol word, SourceSpan span);

/// Fails if the version in force reserves the word, so that it cannot be declared.
void check_newer_name(Context& context, grammar::Symbol name, SourceSpan span);

}  // namespace isl::interpreter
