// Finds the file that a name without a file may mean: scenes come from systems whose file names ignore case, where `\`
// separates folders, and where files lie elsewhere; and names are misspelt. It makes the hint and reads no file;
// file_access.h decides what may be read.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace isl::grammar {

/// A hint that names the file and the remedy, "" if nothing similar lies in the folders. `may_read` is asked with a
/// canonical path, about folders before they are listed and about the file before it is named.
[[nodiscard]] std::string hint_of_similar_file(std::string_view name, const std::vector<std::filesystem::path>& folders,
                                               const std::function<bool(const std::filesystem::path&)>& may_read);

}  // namespace isl::grammar
