#include "interpreter/newer_words.h"

#include <fmt/format.h>

#include <numbers>

namespace isl::interpreter {

void note_newer_word(Context& context, grammar::Symbol word, SourceSpan span) {
  if (!context.version.is_stated_below(LanguageVersion::kWithNewerWords)) return;
  if (!context.noted_words.insert(word).second) return;
  context.note(span, fmt::format("`{}` is a word of version 3.8 of the language", context.text(word)),
               "POV-Ray 3.7 does not know it; `#version 3.8;` at the scene's beginning states the newer version");
}

Value newer_value(Context& context, grammar::Symbol word, SourceSpan span) {
  note_newer_word(context, word, span);
  if (word == grammar::newer_word::kw_tau) return Value(2 * std::numbers::pi);
  return {ValueKind::dictionary, make_shared_value<DictionaryValue>(context.scopes.slots(), context.memory)};
}

void check_newer_name(Context& context, grammar::Symbol name, SourceSpan span) {
  if (!grammar::is_newer_word(name) || context.version.number() < LanguageVersion::kWithNewerWords) return;
  context.fail(span, fmt::format("`{}` is reserved since version 3.8 of the language", context.text(name)),
               "begin names with a capital letter");
}

}  // namespace isl::interpreter
