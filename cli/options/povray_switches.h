// Recognises POV-Ray's own switches (`+W640`, `Height=480`), which its users type by habit, so that the message can
// name ours.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace isl::cli {

struct PovraySwitches {
  std::string first;       ///< the first such argument, as given
  std::string equivalent;  ///< our command line that does the same: `isl render scene.pov -s 640x480`
  std::string ignored;     ///< switches without counterpart, blank-separated; "" when none
};

/// Empty when no argument is in POV-Ray's style. `-I` and `-D` are ours and never count by themselves.
[[nodiscard]] std::optional<PovraySwitches> find_povray_switches(std::span<const std::string> arguments);

}  // namespace isl::cli
