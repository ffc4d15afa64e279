// Names and places of the files that a command writes: decided, compared with the inputs and tried before a ray is
// traced. An output is a file's name, or `png:-` and the like for standard output.
#pragma once

#include "base/files/output_set.h"
#include "cli/output/exit_code.h"
#include "renderer/image/aov.h"
#include "renderer/image/image_file.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isl::cli {

/// The error in a choice of output files, and the exit code for it.
struct OutputProblem {
  ExitCode code = ExitCode::done;
  std::string message;

  [[nodiscard]] bool none() const { return code == ExitCode::done; }
};

/// `asked`, or `<scene name>.png` in the current folder.
[[nodiscard]] std::vector<std::filesystem::path> output_files(const std::vector<std::filesystem::path>& asked,
                                                              const std::string& scene_name);

/// The format of an output by its name, or "".
[[nodiscard]] std::string output_format(const std::filesystem::path& output);

/// A file that the command writes, and how messages call it: `-o a.png`, `the layer a.cost.png`.
struct OutputPlace {
  std::filesystem::path file;
  std::string role;
};

/// Checks that the formats of pictures are known and that standard output can take one of them.
[[nodiscard]] OutputProblem check_pictures(const std::vector<std::filesystem::path>& pictures);

/// Notes the files in the run's register and tries their places; standard output, too. No two of them may be one file,
/// and none may be a file that the run reads. Leaves no trace on the disk.
[[nodiscard]] OutputProblem claim(OutputSet& outputs, const std::vector<OutputPlace>& places);

/// A layer's own picture, beside the picture.
struct LayerFile {
  std::filesystem::path file;
  const render::Aov* layer;
};

/// `NAME.LAYER.EXT` for every NAME.EXT that holds no layers itself, and every layer that has a picture.
[[nodiscard]] std::vector<LayerFile> layer_files(const std::vector<std::filesystem::path>& files,
                                                 const render::Aovs& layers);

/// `NAME.partial.EXT` for each `NAME.EXT`: the file for an interrupted picture. None for standard output, whose reader
/// could not distinguish it from a complete one.
[[nodiscard]] std::vector<std::filesystem::path> partial_names(const std::vector<std::filesystem::path>& files);

/// The output's name in messages: the file, or standard output.
[[nodiscard]] std::string display_name(const std::filesystem::path& output);

/// Makes files of a run's results. All are complete and synced before the first takes its place; after a failure the
/// others are still written, since they may have taken long, and the one that failed is kept elsewhere if possible.
class OutputWriter {
 public:
  explicit OutputWriter(OutputSet& outputs) : outputs_(outputs) {}

  void add(const std::filesystem::path& output, const render::Image& image, const render::ImageFileOptions& options);
  void add_text(const std::filesystem::path& file, std::string_view text);

  /// Puts the files of the run in their places, those of the scene too, then writes to standard output. Returns the
  /// messages of all failures.
  [[nodiscard]] std::vector<std::string> finish();

 private:
  void note(std::string problem);

  OutputSet& outputs_;
  std::vector<unsigned char> standard_output_;
  std::vector<std::string> problems_;
};

}  // namespace isl::cli
