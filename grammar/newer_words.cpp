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
  return fmt::format("`{}` came with version 3.8 of the language, which is not known here", name);
}

}  // namespace isl::grammar
