// Giving a file new content wholly or not at all: written beside its place under another name, then renamed over it.
// So neither a link that is put there meanwhile nor another name of the same file is ever written through.
#pragma once

#include <string>
#include <string_view>

namespace isl::grammar {

/// `name` in the open folder `folder`. Returns what went wrong, or "". The permissions of what was there stay.
[[nodiscard]] std::string replace_file(int folder, const std::string& name, std::string_view bytes);

}  // namespace isl::grammar
