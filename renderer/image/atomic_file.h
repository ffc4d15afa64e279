// Files that are there wholly or not at all: written beside their place under another name, then renamed over it.
#pragma once

#include <span>
#include <string>

namespace isl::render {

/// Why `path` could not be written, or "" if it could: the folder is missing or closed to us, the place is a folder or
/// a device, or a file that we may not write. Leaves nothing behind. Texts are in lower case and name the path.
[[nodiscard]] std::string why_not_writable(const std::string& path);

/// Makes `bytes` the content of `path`; what was there before stays untouched unless this succeeds. A symbolic link is
/// followed. Returns what went wrong, or "".
[[nodiscard]] std::string write_atomically(const std::string& path, std::span<const unsigned char> bytes);

}  // namespace isl::render
