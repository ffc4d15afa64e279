// An .ini file of POV-Ray's in place of a scene: its settings become our options with the same meaning, unless the
// command line gives them itself. Reads that one file, and tests whether files exist.
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
  std::string section;  ///< "": none is requested
};

/// Empty if the scene's name is not that of an .ini file.
[[nodiscard]] std::optional<IniName> ini_name(const std::filesystem::path& scene);

/// Tells if an option, such as `--size`, was given on the command line.
using IsSaid = std::function<bool(const std::string& option)>;

/// Fills the options that were not given from the settings of `ini`, and stores its text in `scene.ini` with all
/// messages: settings without counterpart are warnings, mistakes are errors. Names are relative to the current folder,
/// as in POV-Ray, and if nothing is there, to the file's.
void apply_ini(const IniName& ini, std::string text, const IsSaid& is_said, SceneOptions& scene,
               PictureOptions& picture);

}  // namespace isl::cli
