#include "grammar/newer_words.h"

#include <fmt/format.h>

namespace isl::grammar {

std::string newer_word_message(std::string_view name) {
  return fmt::format("`{}` is a word of version 3.8 of the language that has no meaning here", name);
}

}  // namespace isl::grammar
