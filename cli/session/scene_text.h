// What a scene prints (#debug): on standard error, as it is. A terminal gets it without control characters, which would
// let a stranger's file clear the screen, name the window or hide what was printed before.
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
