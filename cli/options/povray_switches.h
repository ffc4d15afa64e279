// POV-Ray's own switches (`+W640`, `Height=480`), which a POV-Ray user's fingers know: recognised so as to answer with
// ours.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace isl::cli {

struct PovraySwitches {
  std::string first;       ///< the first such argument, as given
  std::string equivalent;  ///< the command line of ours that does the same: `isl render scene.pov -s 640x480`
  std::string ignored;     ///< those that have no counterpart, blank-separated; "" when none
};

/// Empty when no argument is in POV-Ray's style. `-I` and `-D` are ours and never count by themselves.
[[nodiscard]] std::optional<PovraySwitches> find_povray_switches(std::span<const std::string> arguments);

}  // namespace isl::cli
