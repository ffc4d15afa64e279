#include "cli/povray_switches.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

namespace isl::cli {
namespace {

using std::string_view;

/// A switch of POV-Ray's, and ours where ours takes the same value. Facts from its manual, "Command-Line and INI-File
/// Options".
struct Spelling {
  string_view letters;  ///< of the short form
  string_view key;      ///< of the long form (`Key=value`), in lower case
  string_view ours = {};
};

/// Longer letters first, because the value follows without a blank.
constexpr std::array kSpellings = std::to_array<Spelling>({
    {"KFI", "initial_frame"},
    {"KFF", "final_frame"},
    {"KI", "initial_clock"},
    {"KF", "final_clock"},
    {"SC", "start_column"},
    {"SR", "start_row"},
    {"EC", "end_column"},
    {"ER", "end_row"},
    {"UA", "output_alpha"},
    {"WT", "work_threads", "-t"},
    {"AM", "sampling_method"},
    {"AG", "antialias_gamma"},
    {"HI", "include_header"},
    {"MB", "bounding_threshold"},
    {"GA", "all_console"},
    {"I", "input_file_name"},
    {"O", "output_file_name"},
    {"W", "width"},
    {"H", "height"},
    {"A", "antialias_threshold"},
    {"Q", "quality", "--quality"},
    {"L", "library_path", "-I"},
    {"K", "clock", "--clock"},
    {"F", "output_file_type"},
    {"R", "antialias_depth"},
    {"J", "jitter_amount"},
    {"D", "display"},
    {"P", "pause_when_done"},
    {"V", "verbose"},
    {"C", "continue_trace"},
    {"B", "buffer_output"},
    {"X", "test_abort"},
});
constexpr Spelling kDeclare{"", "declare", "-D"};  // has no short form

/// One switch as given.
struct Setting {
  Spelling spelling;
  std::string value;
  bool on = true;  ///< `-A` turns off what `+A` turns on
};

bool same_letters(string_view text, string_view letters) {
  return text.size() >= letters.size() && std::equal(letters.begin(), letters.end(), text.begin(), [](char a, char b) {
           return a == std::toupper(static_cast<unsigned char>(b));
         });
}

std::string lower(string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

std::optional<Setting> short_switch(string_view argument) {
  const bool plus = argument.starts_with('+');
  // Lower-case letters after `-` are ours or mistakes in ours; -I and -D are ours.
  const bool minus = argument.starts_with('-') && argument.size() > 1 &&
                     std::isupper(static_cast<unsigned char>(argument[1])) && argument[1] != 'I' && argument[1] != 'D';
  if ((!plus && !minus) || argument.size() < 2) return std::nullopt;
  for (const Spelling& spelling : kSpellings) {
    if (same_letters(argument.substr(1), spelling.letters)) {
      return Setting{spelling, std::string(argument.substr(1 + spelling.letters.size())), plus};
    }
  }
  return std::nullopt;
}

std::optional<Setting> long_setting(string_view argument) {
  const std::size_t equals = argument.find('=');
  if (equals == string_view::npos || argument.starts_with('-')) return std::nullopt;
  const std::string key = lower(argument.substr(0, equals));
  std::string value(argument.substr(equals + 1));
  if (key == kDeclare.key) return Setting{kDeclare, std::move(value)};
  const auto row =
      std::find_if(kSpellings.begin(), kSpellings.end(), [&](const Spelling& spelling) { return spelling.key == key; });
  if (row == kSpellings.end()) return std::nullopt;
  return Setting{*row, std::move(value)};
}

/// Whether an option of ours reads the argument after it (for `--name` that is a guess on the safe side).
bool takes_next(string_view option) {
  constexpr std::array kShort = std::to_array<string_view>({"-D", "-I", "-o", "-s", "-t"});
  return std::find(kShort.begin(), kShort.end(), option) != kShort.end() ||
         (option.starts_with("--") && option.find('=') == string_view::npos);
}

std::string quoted(string_view value) {
  return value.find_first_of(" \t\"'$") == string_view::npos ? std::string(value) : fmt::format("'{}'", value);
}

/// POV-Ray's letter for a file type; its PNG is the default of both programs.
string_view extension(string_view type) {
  switch (type.empty() ? 'N' : static_cast<char>(std::toupper(static_cast<unsigned char>(type.front())))) {
    case 'P': return ".ppm";
    case 'J': return ".jpg";
    case 'E': return ".exr";
    case 'H': return ".hdr";
    default: return ".png";
  }
}

/// Collects settings and writes our command line.
class Translation {
 public:
  void add(const Setting& setting, const std::string& argument) {
    const string_view key = setting.spelling.key;
    if (!setting.spelling.ours.empty()) {
      options_ += fmt::format(" {} {}", setting.spelling.ours, quoted(setting.value));
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
    std::string line = "isl render " + (scene_.empty() ? "SCENE" : quoted(scene_));
    if (!output_.empty()) {
      line += " -o " + quoted(output_);
    } else if (extension(type_) != ".png") {
      line += fmt::format(" -o NAME{}", extension(type_));
    }
    if (!width_.empty() || !height_.empty()) {
      line += fmt::format(" -s {}x{}", width_.empty() ? "800" : width_, height_.empty() ? "600" : height_);
    }
    line += options_;
    if (has_window_) line += " --crop X0,Y0,X1,Y1";  // theirs counts from 1, or in shares of the picture
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
    if (i > 0 && takes_next(arguments[i - 1])) continue;  // `-D Width=3` is ours
    auto setting = short_switch(argument);
    if (!setting) setting = long_setting(argument);
    if (setting) {
      if (!first) first = argument;
      translation.add(*setting, argument);
    } else if (argument.ends_with(".pov") || argument.ends_with(".isl")) {
      translation.set_scene(argument);
    }
  }
  if (!first) return std::nullopt;
  return PovraySwitches{*first, translation.command_line(), translation.ignored()};
}

}  // namespace isl::cli
