// Which of POV-Ray's words mean something that is not here: "not supported" rather than "unexpected".
#pragma once

#include "grammar/symbols.h"

#include <string>
#include <string_view>

namespace isl::interpreter {

/// Of words that begin a construct; those that stand only inside one that is not supported are skipped with it.
[[nodiscard]] bool is_unsupported_word(grammar::Symbol word);
/// Words of POV-Ray 3.8, which are ordinary names in a scene of 3.7.
[[nodiscard]] bool is_newer_word(std::string_view name);
[[nodiscard]] std::string newer_word_message(std::string_view name);
/// Those that make an object.
[[nodiscard]] bool is_unsupported_object(grammar::Symbol word);

}  // namespace isl::interpreter
