// The file that a name may mean which names none: scenes come from systems where capitals do not count, `\` separates
// folders, and files lie elsewhere. Finds what to say, and reads no file; what may be read is file_access.h's.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace isl::grammar {

/// A hint that names the file and what to do, "" where nothing similar lies in the folders. `may_read` is asked with a
/// canonical path, of folders before they are listed and of the file before it is named.
[[nodiscard]] std::string hint_of_similar_file(std::string_view name, const std::vector<std::filesystem::path>& folders,
                                               const std::function<bool(const std::filesystem::path&)>& may_read);

}  // namespace isl::grammar
