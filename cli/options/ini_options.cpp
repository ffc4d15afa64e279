#include "cli/options/ini_options.h"

#include "cli/options/ini_animation.h"
#include "cli/options/option_values.h"
#include "cli/options/povray_options.h"
#include "cli/output/output_files.h"
#include "grammar/similar_file.h"
#include "renderer/image/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

namespace isl::cli {
namespace {

namespace fs = std::filesystem;
using std::string_view;

/// POV-Ray's threshold for `Antialias=on` without one.
constexpr double kPovrayThreshold = 0.3;

class IniTranslation {
 public:
  IniTranslation(const IniName& name, const IsSaid& is_said, SceneOptions& scene, PictureOptions& picture)
      : name_(name), is_said_(is_said), scene_(scene), picture_(picture) {}

  std::vector<IniRemark> take(IniSettings read) {
    remarks_ = std::move(read.remarks);
    for (const IniSetting& setting : read.settings) translate(setting);
    finish_scene();
    finish_size();
    finish_animation();
    finish_output();
    finish_bits();
    finish_antialiasing();
    finish_crop();
    // Settings of the command line override those of the file, so they come later; its folders are searched first.
    scene_.defines.insert(scene_.defines.begin(), defines_.begin(), defines_.end());
    scene_.include_paths.insert(scene_.include_paths.end(), folders_.begin(), folders_.end());
    std::ranges::stable_sort(remarks_, {}, &IniRemark::begin);
    return std::move(remarks_);
  }

 private:
  void remark(Severity severity, const IniSetting& setting, std::string message, std::string hint = {}) {
    remarks_.push_back({severity, setting.begin, setting.end, std::move(message), std::move(hint)});
  }

  /// The value if it can be read; otherwise reports the reason.
  template <class T>
  std::optional<T> accept(const IniSetting& setting, const Parsed<T>& parsed) {
    if (parsed.ok()) return parsed.value();
    remark(Severity::error, setting, fmt::format("`{}`: {}", setting.key, parsed.message()));
    return std::nullopt;
  }

  std::optional<int> integer(const IniSetting& setting, int low, int high) {
    const auto value = accept(setting, parse_integer(setting.value, low, high));
    return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
  }
  std::optional<double> number(const IniSetting& setting, double low, double high) {
    return accept(setting, parse_number(setting.value, low, high));
  }
  std::optional<bool> truth(const IniSetting& setting) {
    if (setting.is_switch) return setting.on;
    const std::string value = lower_case(setting.value);
    for (const string_view yes : {"on", "true", "yes", "1"}) {
      if (value == yes) return true;
    }
    for (const string_view no : {"off", "false", "no", "0"}) {
      if (value == no) return false;
    }
    remark(Severity::error, setting, fmt::format("`{}`: expected on or off, found `{}`", setting.key, setting.value));
    return std::nullopt;
  }

  void translate(const IniSetting& setting) {
    const string_view key = setting.key;
    if (key == "input_file_name") {
      input_ = setting;
    } else if (key == "output_file_name") {
      output_ = setting;
    } else if (key == "output_file_type") {
      set_type(setting);
    } else if (key == "width") {
      width_ = integer(setting, 1, kMaxPictureSide);
    } else if (key == "height") {
      height_ = integer(setting, 1, kMaxPictureSide);
    } else if (key == "antialias") {
      antialias_ = truth(setting);
    } else if (key == "antialias_threshold") {
      set_threshold(setting);
    } else if (key == "quality") {
      const auto value = integer(setting, 0, 11);
      if (value && !is_said_("--quality")) picture_.quality = *value;
    } else if (key == "bits_per_color" || key == "bits_per_colour") {
      bits_ = integer(setting, 1, 16);
    } else if (key == "output_alpha") {
      if (const auto value = truth(setting); value && *value) picture_.alpha = true;
    } else if (key == "work_threads") {
      const auto value = integer(setting, 1, 1024);
      if (value && !is_said_("--threads")) picture_.threads = *value;
    } else if (key == "library_path") {
      folders_.push_back(located(setting.value));
    } else if (key == "declare") {
      if (const auto define = accept(setting, parse_define(setting.value))) defines_.push_back(*define);
    } else if (key == "start_column" || key == "start_row" || key == "end_column" || key == "end_row") {
      if (const auto value = number(setting, 0, kMaxPictureSide)) window_[setting.key] = *value;
    } else if (!translate_time(setting)) {
      remark(Severity::warning, setting, fmt::format("`{}` has no counterpart here; it is ignored", setting.key));
    }
  }

  bool translate_time(const IniSetting& setting) {
    const string_view key = setting.key;
    constexpr int kLastFrame = std::numeric_limits<int>::max() - 1;
    if (key == "clock") {
      animation_.clock = number(setting, -kUnbounded, kUnbounded);
    } else if (key == "initial_frame") {
      if (const auto value = integer(setting, 0, kLastFrame)) animation_.initial_frame = *value;
    } else if (key == "final_frame") {
      if (const auto value = integer(setting, 0, kLastFrame)) animation_.final_frame = *value;
      final_frame_ = setting;
    } else if (key == "initial_clock") {
      if (const auto value = number(setting, -kUnbounded, kUnbounded)) animation_.initial_clock = *value;
    } else if (key == "final_clock") {
      if (const auto value = number(setting, -kUnbounded, kUnbounded)) animation_.final_clock = *value;
    } else if (key == "cyclic_animation") {
      animation_.is_cyclic = truth(setting).value_or(false);
    } else if (key == "subset_start_frame") {
      animation_.first_wanted = number(setting, 0, kLastFrame);
    } else {
      return false;
    }
    return true;
  }

  void set_type(const IniSetting& setting) {
    extension_ = extension_of_povray_type(setting.value);
    // `N8` combines the type and the bits, and `Ng`, `Ng16` ask for shades of grey, as does `Grayscale_Output`.
    std::string rest = setting.value.empty() ? "" : setting.value.substr(1);
    if (rest.starts_with('g') || rest.starts_with('G')) {
      remark(Severity::warning, setting, "pictures are written in colour, not in shades of grey");
      rest.erase(0, 1);
    }
    if (extension_ == ".png" && !rest.empty()) {
      if (const auto bits = accept(setting, parse_integer(rest, 1, 16))) bits_ = static_cast<int>(*bits);
    }
    if (!extension_.empty()) return;
    extension_ = ".png";
    remark(Severity::warning, setting,
           fmt::format("isl cannot write files of type `{}`; it writes a PNG", setting.value));
  }

  /// `+A0.2` combines both settings.
  void set_threshold(const IniSetting& setting) {
    if (setting.is_switch) antialias_ = setting.on;
    if (setting.is_switch && setting.value.empty()) return;
    threshold_ = number(setting, 0, kUnbounded);
  }

  /// A file or folder as POV-Ray finds it, in the current folder; else beside the .ini file, if it is there.
  [[nodiscard]] fs::path located(const fs::path& name) const {
    std::error_code error;
    const fs::path beside = name_.file.parent_path() / name;
    return !fs::exists(name, error) && fs::exists(beside, error) ? beside : name;
  }

  void finish_scene() {
    if (!input_) {
      remarks_.push_back({Severity::error, 0, 0, "the file names no scene", "add `Input_File_Name=NAME.pov`"});
      return;
    }
    std::error_code error;
    fs::path file = located(input_->value);
    if (!fs::exists(file, error) && !file.has_extension()) file = located(input_->value + ".pov");
    for (const fs::path& folder : folders_) {
      if (!fs::exists(file, error) && fs::exists(folder / input_->value, error)) file = folder / input_->value;
    }
    scene_.scene = file;
    if (fs::exists(file, error)) return;
    const fs::path beside = name_.file.parent_path();
    std::string hint = grammar::hint_of_similar_file(input_->value, {"", beside}, [](const fs::path&) { return true; });
    if (hint.empty()) {
      hint = fmt::format("looked for it in the current folder{}", beside.empty() ? "" : " and in " + beside.string());
    }
    remark(Severity::error, *input_, fmt::format("cannot find the scene `{}`", input_->value), std::move(hint));
  }

  void finish_size() {
    if (is_said_("--size")) return;
    scene_.is_size_known |= width_ || height_;
    if (width_) scene_.size.width = *width_;
    if (height_) scene_.size.height = *height_;
  }

  void finish_animation() {
    const bool says_frame = is_said_("--frame");
    if (!animation_.has_frames()) {
      if (animation_.clock && !is_said_("--clock")) scene_.clock = *animation_.clock;
      scene_.clock_on = scene_.clock_on || animation_.clock.has_value();
      return;
    }
    const std::string range = fmt::format("{} to {}", animation_.initial_frame, animation_.final_frame);
    const IniSetting place = final_frame_.value_or(IniSetting{});
    if (!says_frame) {
      scene_.frame = animation_.first_frame();
      remark(Severity::note, place, fmt::format("frame {} of {} is rendered", scene_.frame, range),
             "`--frame N` renders another");
    } else if (scene_.frame < animation_.initial_frame || scene_.frame > animation_.final_frame) {
      remark(Severity::error, place,
             fmt::format("--frame: expected one of the frames {}, found {}", range, scene_.frame));
    }
    scene_.clock_on = true;
    if (!is_said_("--clock")) scene_.clock = animation_.clock_of(scene_.frame);
    const std::vector<Define> variables = animation_.variables();
    defines_.insert(defines_.begin(), variables.begin(), variables.end());
  }

  /// Names files as POV-Ray does: an extension that is not the type's stays, and the type's is appended, `DIR/` is a
  /// folder for a file with the scene's name, and frames are numbered.
  void finish_output() {
    if (!picture_.outputs.empty()) return;
    const std::string number = animation_.has_frames() ? animation_.number_of(scene_.frame) : "";
    if (!output_ && number.empty() && (extension_.empty() || extension_ == ".png")) return;
    if (output_ && output_->value == "-") {
      picture_.outputs.emplace_back(fmt::format("{}:-", extension_.empty() ? "png" : extension_.substr(1)));
      return;
    }
    fs::path file = output_ ? fs::path(output_->value) : fs::path();
    if (file.filename().empty()) file /= scene_.scene.stem();
    const bool is_right = extension_.empty() ? !render::image_format_of(file.string()).empty()
                                             : lower_case(file.extension().string()) == extension_;
    const std::string extension = is_right             ? file.extension().string()
                                  : extension_.empty() ? ".png"
                                                       : std::string(extension_);
    if (is_right) file.replace_extension();
    file += number + extension;
    picture_.outputs.push_back(std::move(file));
  }

  /// PNG has 8 bits or 16; POV-Ray rounds up too. Its other types have one number of bits here.
  void finish_bits() {
    const bool is_png =
        std::ranges::all_of(picture_.outputs, [](const fs::path& file) { return output_format(file) == "png"; });
    if (bits_ && is_png && !is_said_("--bits")) picture_.bits = *bits_ <= 8 ? 8 : 16;
  }

  /// A file without a setting for antialiasing gets isl's own default: it costs little and looks better.
  void finish_antialiasing() {
    if (is_said_("--aa") || is_said_("--samples") || is_said_("--max-noise")) return;
    if (antialias_ && !*antialias_) {
      picture_.samples = 1;
    } else if (antialias_ || threshold_) {
      picture_.aa_threshold = threshold_.value_or(kPovrayThreshold);
    }
  }

  /// POV-Ray counts columns and rows from 1 to the last included; a number up to 1 is a fraction of the picture.
  void finish_crop() {
    if (window_.empty() || is_said_("--crop")) return;
    const auto side = [this](const char* key, int whole, int otherwise, bool is_start) {
      const auto found = window_.find(key);
      if (found == window_.end()) return otherwise;
      const double value = found->second;
      if (value == 1 && is_start) return 0;
      if (value <= 1) return static_cast<int>(std::lround(whole * value));
      return static_cast<int>(value) - (is_start ? 1 : 0);
    };
    const auto [width, height] = scene_.size;
    const std::array<int, 4> crop{side("start_column", width, 0, true), side("start_row", height, 0, true),
                                  side("end_column", width, width, false), side("end_row", height, height, false)};
    if (crop[0] < crop[2] && crop[1] < crop[3] && crop[2] <= width && crop[3] <= height) {
      picture_.crop = crop;
      return;
    }
    remarks_.push_back({Severity::error,
                        0,
                        0,
                        fmt::format("the area from `Start_Column` to `End_Row` is empty or reaches beyond the "
                                    "picture of {}x{} pixels",
                                    width, height),
                        {}});
  }

  const IniName& name_;
  const IsSaid& is_said_;
  SceneOptions& scene_;
  PictureOptions& picture_;
  std::vector<IniRemark> remarks_;
  std::optional<IniSetting> input_, output_, final_frame_;
  std::optional<int> width_, height_, bits_;
  std::optional<bool> antialias_;
  std::optional<double> threshold_;
  string_view extension_;  ///< of the requested type; "": none
  std::map<std::string, double, std::less<>> window_;
  IniAnimation animation_;
  std::vector<fs::path> folders_;
  std::vector<Define> defines_;
};

}  // namespace

std::optional<IniName> ini_name(const fs::path& scene) {
  const std::string text = scene.string();
  const std::size_t open = text.ends_with(']') ? text.rfind('[') : std::string::npos;
  const std::string file = text.substr(0, open);
  if (!lower_case(file).ends_with(".ini")) return std::nullopt;
  return IniName{file, open == std::string::npos ? "" : text.substr(open + 1, text.size() - open - 2)};
}

void apply_ini(const IniName& ini, std::string text, const IsSaid& is_said, SceneOptions& scene,
               PictureOptions& picture) {
  IniSettings read = read_ini(text, ini.section);
  std::vector<IniRemark> remarks = IniTranslation(ini, is_said, scene, picture).take(std::move(read));
  scene.ini = IniText{ini.file.string(), std::move(text), std::move(remarks)};
}

}  // namespace isl::cli
