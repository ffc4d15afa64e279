// Prints a scene's text (#debug) on standard error, unchanged. For a terminal, control characters are removed: they
// would let a stranger's file clear the screen, name the window or hide earlier output.
#pragma once

#include "cli/output/printable_text.h"

#include <unistd.h>

#include <cstdio>
#include <string_view>

namespace isl::cli {

inline void print_scene_text(std::string_view text) {
  static const bool is_terminal = isatty(STDERR_FILENO) != 0;
  if (is_terminal) {
    const std::string visible = with_visible_controls(text);
    std::fwrite(visible.data(), 1, visible.size(), stderr);
  } else {
    std::fwrite(text.data(), 1, text.size(), stderr);
  }
}

}  // namespace isl::cli
