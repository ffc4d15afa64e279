// The one place from which text goes to standard output and standard error. What a scene, a file's name or an argument
// puts into it must not clear a screen, rename a window or make a line read other than it is, on a terminal or later,
// in a log that came through a pipe. Only the progress bar (progress.h) and check_failed (base/check.h), which print no
// text of others, go without it, and pictures (standard_output.h).
#pragma once

#include "cli/output/safe_text.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace isl::cli {

enum class Stream : std::uint8_t { output, error };

/// Messages and results. Standard output is buffered until finish_standard_output().
void print(Stream stream, const SafeText& text);
void print(Stream stream, std::string_view any);

/// Text whose bytes may matter: what a scene prints, a dump. It goes into a file as it is; everything else gets it with
/// visible controls.
void print_content(Stream stream, std::string_view content);

/// A JSON document, on standard output. Its content stays exactly the same: JSON has escapes of its own.
void print_json(std::string_view document);

/// True if colours may be written there: it is a terminal, and NO_COLOR is not set.
[[nodiscard]] bool wants_colour(Stream stream);

/// Writes what is buffered. Returns the first error of standard output, as a message, or "".
[[nodiscard]] std::string finish_standard_output();

}  // namespace isl::cli
