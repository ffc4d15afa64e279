// Words of POV-Ray 3.8. Scenes of 3.7 may use them as names, so they are identifiers: each has its meaning only where
// its text can have no other (token_stream.cpp), or where no such name is declared. In a scene of 3.8 they cannot be
// declared.
#pragma once

#include "grammar/symbols.h"

#include <string>
#include <string_view>

namespace isl::grammar {

/// The message about such a word where it has no meaning.
[[nodiscard]] std::string newer_word_message(std::string_view name);

}  // namespace isl::grammar
