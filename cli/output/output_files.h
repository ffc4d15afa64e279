// Names and places of the pictures: decided and tried before a ray is traced; a file is written whole or not at all. An
// output is a file's name, or `png:-` and the like for standard output.
#pragma once

#include "cli/output/exit_code.h"
#include "renderer/image/aov.h"
#include "renderer/image/atomic_file.h"
#include "renderer/image/image_file.h"

#include <filesystem>
#include <string>
#include <utility>
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

/// Checks that formats are known, no file is named twice, and each place is writable. Leaves no trace on the disk.
[[nodiscard]] OutputProblem check_outputs(const std::vector<std::filesystem::path>& files);

/// Checks that a file can be written there; for files that are not pictures.
[[nodiscard]] OutputProblem check_place(const std::filesystem::path& file);

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

/// The pictures of one run. All are encoded, written and synced before the first takes its place; after a failure the
/// others are still written, since they may have taken long.
class OutputWriter {
 public:
  explicit OutputWriter(render::ImageFileOptions options) : options_(std::move(options)) {}

  void add(const std::filesystem::path& output, const render::Image& image);

  /// Puts the files in their places, then writes to standard output. Returns the first error.
  [[nodiscard]] OutputProblem finish();

 private:
  void note(std::string problem);

  render::ImageFileOptions options_;
  std::vector<render::StagedFile> staged_;
  std::vector<unsigned char> standard_output_;
  OutputProblem first_;
};

/// Replaces a text file as a whole.
[[nodiscard]] OutputProblem write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace isl::cli
