// An .ini file of POV-Ray's in place of a scene: its settings become the options of ours with the same meaning, where
// the command line does not say them itself. Reads that one file, and asks which files exist.
#pragma once

#include "cli/options/ini_file.h"
#include "cli/options/options.h"

#include <functional>
#include <string>
#include <string_view>

namespace isl::cli {

/// `scene.ini` or `scene.ini[section]`.
struct IniName {
  std::filesystem::path file;
  std::string section;  ///< "": none is asked for
};

/// Empty where the name of a scene is none of an .ini file.
[[nodiscard]] std::optional<IniName> ini_name(const std::filesystem::path& scene);

/// Tells if an option, such as `--size`, stands on the command line.
using IsSaid = std::function<bool(const std::string& option)>;

/// Fills the options that are not said from the settings of `ini`, and notes its text in `scene.ini` with all there is
/// to tell: settings without counterpart are warnings, mistakes are errors. Names are relative to the current folder,
/// as POV-Ray has them, and where nothing is there, to the file's.
void apply_ini(const IniName& ini, std::string text, const IsSaid& is_said, SceneOptions& scene,
               PictureOptions& picture);

}  // namespace isl::cli
