// The commands and options for CLI11, with their help texts. Part of options.cpp's work: the values are not checked
// against one another here.
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

/// The values as CLI11 reads them.
struct RawOptions {
  SceneOptions scene;
  PictureOptions picture;
  int plan_quality = 9;
  bool plan_measure = false;
  AccuracyCommand accuracy;           ///< except `scene`
  std::vector<std::string> settings;  ///< for `accuracy`
  std::string library_name;           ///< for `library`
  std::vector<std::string> defines;
  std::string format = "text";
  std::string stage;
};

/// Adds the commands to `app`, and its options to the one named `chosen`; they fill `raw`, which must outlive the
/// parse.
void declare_options(CLI::App& app, RawOptions& raw, std::string_view chosen);

}  // namespace isl::cli
