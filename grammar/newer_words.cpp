#include "grammar/newer_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace isl::grammar {
namespace {

constexpr auto kNewer = std::to_array<std::string_view>(
    {"blend_gamma", "blend_mode", "dictionary", "lemon", "mixed", "optional", "polarity", "potential", "user_defined"});

}  // namespace

bool is_newer_word(std::string_view name) { return std::ranges::find(kNewer, name) != kNewer.end(); }

std::string newer_word_message(std::string_view name) {
  return fmt::format("`{}` is a word of version 3.8 of the language; this program reads 3.7", name);
}

}  // namespace isl::grammar
