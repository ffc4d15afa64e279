// The frames of an animation, as the .ini files of POV-Ray describe them, and the data of one frame. Knows no file.
#pragma once

#include "cli/options/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace isl::cli {

/// POV-Ray's defaults.
struct IniAnimation {
  int initial_frame = 1;
  int final_frame = 1;
  double initial_clock = 0;
  double final_clock = 1;
  bool is_cyclic = false;              ///< the last frame is one step before the final clock
  std::optional<double> clock;         ///< for a picture without animation
  std::optional<double> first_wanted;  ///< up to 1: a fraction of the frames

  [[nodiscard]] bool has_frames() const { return final_frame > initial_frame; }

  [[nodiscard]] int first_frame() const {
    if (!first_wanted) return initial_frame;
    const bool is_share = *first_wanted < 1;
    const double frame = is_share ? initial_frame + *first_wanted * (final_frame - initial_frame) : *first_wanted;
    return static_cast<int>(std::clamp<double>(frame, initial_frame, final_frame));
  }

  /// The value of `final_frame` for the scene: the frame at which the clock reaches its end.
  [[nodiscard]] int end_frame() const { return final_frame + (is_cyclic ? 1 : 0); }
  [[nodiscard]] double clock_delta() const { return (final_clock - initial_clock) / (end_frame() - initial_frame); }
  [[nodiscard]] double clock_of(int frame) const { return initial_clock + (frame - initial_frame) * clock_delta(); }

  /// The number in the name of the frame's file: all have the same length.
  [[nodiscard]] std::string number_of(int frame) const {
    return fmt::format("{:0{}}", frame, fmt::formatted_size("{}", final_frame));
  }

  /// The variables that a scene can read besides its frame and clock.
  [[nodiscard]] std::vector<Define> variables() const {
    return {{"initial_frame", static_cast<double>(initial_frame)},
            {"final_frame", static_cast<double>(end_frame())},
            {"initial_clock", initial_clock},
            {"final_clock", final_clock},
            {"clock_delta", clock_delta()}};
  }
};

}  // namespace isl::cli
