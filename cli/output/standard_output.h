// The standard streams as files: a picture's option to go there (`-o png:-`), the cases where that is impossible, and
// the writing of bytes. While a picture is written there, all other output goes elsewhere. Text goes through console.h.
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

/// Called once, before anything is opened or written. A stream that is closed becomes one that refuses to be used, so
/// that no file of the run gets its number, and with it the messages; a reader that has gone away becomes an error of
/// the writing, no signal.
void prepare_standard_streams();

/// Writes all bytes and returns "", or the error.
[[nodiscard]] std::string write_standard_output(std::span<const unsigned char> bytes);
/// Ignores errors: there is no place to tell them.
void write_standard_error(std::span<const unsigned char> bytes);

}  // namespace isl::cli
