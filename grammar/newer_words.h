// Words of POV-Ray 3.8. They are no words here, because scenes of 3.7 may use them as names; where such a name is
// wrong, it is said that the word is meant.
#pragma once

#include <string>
#include <string_view>

namespace isl::grammar {

[[nodiscard]] bool is_newer_word(std::string_view name);
[[nodiscard]] std::string newer_word_message(std::string_view name);

}  // namespace isl::grammar
