// A picture on standard output: its option (`-o png:-`), the cases where it is impossible, and the writing. While one
// is written there, all other output goes elsewhere.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace isl::cli {

/// The requested format: "png" for `png:-`; "" for anything else, a file's name too.
[[nodiscard]] std::string standard_output_format(const std::filesystem::path& output);

/// A terminal would show a picture's bytes as characters.
[[nodiscard]] bool standard_output_is_terminal();

/// The reason why nothing can be written there, or "": it is closed, or open for reading only.
[[nodiscard]] std::string why_no_standard_output();

/// Writes all bytes and returns "", or the error. A reader that has gone away is such an error, no signal.
[[nodiscard]] std::string write_standard_output(std::span<const unsigned char> bytes);

}  // namespace isl::cli
