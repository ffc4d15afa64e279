// The commands and options as CLI11 knows them, with their help texts. Part of options.cpp's work: from here the values
// are still unchecked against one another.
#pragma once

#include "cli/options/options.h"

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace isl::cli {

/// Thrown by the readers of values inside CLI11's parse, caught in parse_command_line.
struct BadValue {
  std::string option;
  std::string message;
};

/// Where CLI11 puts what it reads.
struct RawOptions {
  SceneOptions scene;
  PictureOptions picture;
  int plan_quality = 9;
  AccuracyCommand accuracy;  ///< but for `scene`
  std::vector<std::string> settings;  ///< of `accuracy`
  std::vector<std::string> defines;
  std::string format = "text";
  std::string stage;
};

/// Adds the commands to `app`, and to the one named `chosen` its options; they fill
/// `raw`, which must outlive the parse.
void declare_options(CLI::App& app, RawOptions& raw, std::string_view chosen);

}  // namespace isl::cli
