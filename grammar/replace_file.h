// Replaces a file's content wholly or not at all: the new content is written beside its place under another name, which
// is then renamed. So neither a link that is put there meanwhile nor another name of the same file is ever written
// through.
#pragma once

#include <string>
#include <string_view>

namespace isl::grammar {

/// Replaces `name` in the open folder `folder`. Returns the error, or "". The permissions of the old file stay.
[[nodiscard]] std::string replace_file(int folder, const std::string& name, std::string_view bytes);

}  // namespace isl::grammar
