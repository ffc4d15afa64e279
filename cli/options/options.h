// The command line as data. Reads the arguments, and the .ini file that they name; checks everything that needs no
// other file; runs nothing.
#pragma once

#include "cli/options/ini_file.h"
#include "cli/options/option_values.h"
#include "cli/options/solver_setting.h"
#include "cli/output/exit_code.h"
#include "interpreter/evaluate.h"
#include "renderer/image/aov.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace isl::cli {

enum class OutputFormat : std::uint8_t { text, json };

/// The .ini file that options were read from, and the messages about it.
struct IniText {
  std::string name;  ///< as the user gave it
  std::string text;
  std::vector<IniRemark> remarks;
};

/// The place of POV-Ray's include files in the search path, where the system has them.
enum class SystemLibraries : std::uint8_t { none, after_ours, before_ours };

/// The options of every command that reads a scene.
struct SceneOptions {
  std::filesystem::path scene;  ///< "-" is standard input
  std::optional<IniText> ini;
  std::vector<std::filesystem::path> include_paths;
  SystemLibraries system_libraries = SystemLibraries::after_ours;
  std::vector<std::filesystem::path> read_folders;   ///< --allow-read
  std::vector<std::filesystem::path> named_folders;  ///< of -I and --allow-read, without those of the .ini file
  std::vector<std::filesystem::path> write_folders;  ///< --allow-write
  std::vector<Define> defines;
  interpreter::Limits limits;
  std::optional<double> max_seconds;         ///< --max-time, of the whole run
  std::uint64_t steps_of_ray = kStepsOfRay;  ///< --max-ray-steps
  bool lenient = false;
  std::vector<std::string> without;  ///< effects to leave out, each known
  double clock = 0;
  bool clock_on = false;  ///< --clock or --frame was given
  int frame = 0;
  PictureSize size;            ///< scenes ask for image_width and image_height
  bool is_size_known = false;  ///< --size was given, or the command makes the picture
  OutputFormat format = OutputFormat::text;
};

/// The defaults of `--aa` and, for scenes with something soft, of `--max-noise`.
inline constexpr double kEdgeThreshold = 0.1, kSoftNoise = 0.01;
/// A smaller noise than the steps of 16 bits have is not to be seen in any file.
inline constexpr double kLeastNoise = 1e-5;

/// The further options of `isl render`. An empty optional means: not given, so the scene or the default decides.
struct PictureOptions {
  std::vector<std::filesystem::path> outputs;  ///< files, or `png:-`; empty: `<scene name>.png`
  int bits = 0;                                ///< bits of a channel in integer formats; 0: the format's default
  int threads = 0;                             ///< 0: all cores
  std::optional<int> samples;
  std::optional<double> aa_threshold;
  std::optional<double> max_noise;  ///< if none of the three is given, the scene decides (render_settings())
  int quality = 9;
  bool alpha = false;
  std::optional<SolverChoice> solver;
  std::optional<render::Tolerance> tolerance;
  bool unblended = false;  ///< blobs without blending: components as solids
  std::string simd;        ///< "": the best that the machine has
  render::Aovs layers;     ///< of --aov, each once, in the order of all_aovs()
  std::optional<std::array<int, 4>> crop;
  std::filesystem::path statistics;  ///< "": none
  bool strict = false;               ///< pixels that are not certain are an error
  bool quiet = false;
};

struct RenderCommand {
  SceneOptions scene;
  PictureOptions picture;
};

struct CheckCommand {
  SceneOptions scene;
};

struct PlanCommand {
  SceneOptions scene;
  int quality = 9;
  bool measure = false;  ///< also render a small picture with and without each effect
};

enum class DumpStage : std::uint8_t { tokens, ast, database, grid };

struct DumpCommand {
  SceneOptions scene;
  DumpStage stage = DumpStage::ast;
};

struct AccuracyCommand {
  SceneOptions scene;
  std::filesystem::path output;         ///< its files' name without extension; "": `<scene name>.accuracy`
  int threads = 0;                      ///< 0: all cores
  std::vector<SolverSetting> settings;  ///< to compare; empty: the ladder of accuracy/ladder.h
  int repeats = 5;                      ///< rounds of timing
  bool unblended = false;               ///< blobs without blending: components as solids
  bool shadows = false;                 ///< also the shadow rays of visible points
};

/// Lists the standard library; reads no scene.
struct LibraryCommand {
  std::string name;  ///< a file, a macro or a declaration; "": an overview
  OutputFormat format = OutputFormat::text;
};

/// Nothing is left to do but to print: help, the version, or the errors of the arguments.
struct Finished {
  ExitCode code = ExitCode::done;
  std::string text;  ///< for standard output when `code` is done, else for standard error
};

using Command =
    std::variant<RenderCommand, CheckCommand, PlanCommand, DumpCommand, AccuracyCommand, LibraryCommand, Finished>;

/// `arguments` are those after the program's name. If the scene is an .ini file, that file is read.
[[nodiscard]] Command parse_command_line(std::span<const std::string> arguments);

}  // namespace isl::cli
