// Words of POV-Ray 3.8. They are not reserved here, because scenes of 3.7 may use them as names; if such a name is
// undeclared, the message says that it is a word of 3.8.
#pragma once

#include <string>
#include <string_view>

namespace isl::grammar {

[[nodiscard]] bool is_newer_word(std::string_view name);
[[nodiscard]] std::string newer_word_message(std::string_view name);

}  // namespace isl::grammar
