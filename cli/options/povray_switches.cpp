#include "cli/options/povray_switches.h"

#include "base/shell_word.h"
#include "cli/options/povray_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

namespace isl::cli {
namespace {

using std::string_view;

/// povray_switch() restricted to the command line: there, lower-case letters after `-` are our options or mistakes in
/// them, and -I and -D are ours.
std::optional<PovraySetting> short_switch(string_view argument) {
  const bool is_ours =
      argument.starts_with('-') && argument.size() > 1 &&
      (std::isupper(static_cast<unsigned char>(argument[1])) == 0 || argument[1] == 'I' || argument[1] == 'D');
  return is_ours ? std::nullopt : povray_switch(argument);
}

std::optional<PovraySetting> long_setting(string_view argument) {
  const std::size_t equals = argument.find('=');
  if (equals == string_view::npos || argument.starts_with('-')) return std::nullopt;
  const PovrayOption* const option = povray_option(argument.substr(0, equals));
  if (option == nullptr) return std::nullopt;
  return PovraySetting{option, std::string(argument.substr(equals + 1))};
}

/// True if one of our options reads the argument after it (for `--name` that is a guess on the safe side).
bool takes_next(string_view option) {
  constexpr std::array kShort = std::to_array<string_view>({"-D", "-I", "-o", "-s", "-t"});
  return std::find(kShort.begin(), kShort.end(), option) != kShort.end() ||
         (option.starts_with("--") && option.find('=') == string_view::npos);
}

/// The extension for a file type; PNG, the default of both programs, for types that isl cannot write.
string_view extension(string_view type) {
  const string_view known = extension_of_povray_type(type);
  return known.empty() ? ".png" : known;
}

/// Collects settings and writes our command line.
class Translation {
 public:
  void add(const PovraySetting& setting, const std::string& argument) {
    const string_view key = setting.option->key;
    if (!setting.option->ours.empty()) {
      options_ += fmt::format(" {} {}", setting.option->ours, shell_word(setting.value));
    } else if (key == "antialias_threshold") {
      options_ += setting.on ? " --aa " + (setting.value.empty() ? "0.3" : setting.value) : " --samples 1";
    } else if (key == "output_alpha" && setting.on) {
      options_ += " --alpha";
    } else if (key.starts_with("start_") || key.starts_with("end_")) {
      has_window_ = true;
    } else if (std::string* const place = place_of(key)) {
      *place = setting.value;
    } else {
      ignored_ += (ignored_.empty() ? "" : " ") + argument;
    }
  }

  void set_scene(const std::string& scene) { scene_ = scene; }
  [[nodiscard]] const std::string& ignored() const { return ignored_; }

  [[nodiscard]] std::string command_line() const {
    std::string line = "isl render " + (scene_.empty() ? "SCENE" : shell_word(scene_));
    if (!output_.empty()) {
      line += " -o " + shell_word(output_);
    } else if (extension(type_) != ".png") {
      line += fmt::format(" -o NAME{}", extension(type_));
    }
    if (!width_.empty() || !height_.empty()) {
      line += fmt::format(" -s {}x{}", width_.empty() ? "800" : width_, height_.empty() ? "600" : height_);
    }
    line += options_;
    if (has_window_) line += " --crop X0,Y0,X1,Y1";  // POV-Ray counts from 1, or in fractions of the picture
    return line;
  }

 private:
  std::string* place_of(string_view key) {
    if (key == "input_file_name") return &scene_;
    if (key == "output_file_name") return &output_;
    if (key == "output_file_type") return &type_;
    if (key == "width") return &width_;
    if (key == "height") return &height_;
    return nullptr;
  }

  std::string scene_, output_, type_, width_, height_, options_, ignored_;
  bool has_window_ = false;
};

}  // namespace

std::optional<PovraySwitches> find_povray_switches(std::span<const std::string> arguments) {
  std::optional<std::string> first;
  Translation translation;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (i > 0 && takes_next(arguments[i - 1])) continue;  // the value of our own option, as in `-D Width=3`
    auto setting = short_switch(argument);
    if (!setting) setting = long_setting(argument);
    if (setting) {
      if (!first) first = argument;
      translation.add(*setting, argument);
    } else if (argument.ends_with(".pov") || argument.ends_with(".isl") || argument.ends_with(".ini")) {
      translation.set_scene(argument);
    }
  }
  if (!first) return std::nullopt;
  return PovraySwitches{*first, translation.command_line(), translation.ignored()};
}

}  // namespace isl::cli
