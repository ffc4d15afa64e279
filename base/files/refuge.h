// Another place for a result that cannot be written where it belongs, because the disk is full or its folder is gone:
// hours of work must not be lost for that.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace isl {

/// Writes and syncs `bytes` as a new file called `name` (or `NAME-2.EXT` …) in the first of these folders that takes
/// it: `$XDG_CACHE_HOME/isl` (by default `~/.cache/isl`), `$TMPDIR` or `/tmp`, the home folder. Returns its path, empty
/// if none took it. Only the user may read it, since others may use such a folder, too.
[[nodiscard]] std::filesystem::path keep_elsewhere(const std::string& name, std::span<const unsigned char> bytes);

}  // namespace isl
