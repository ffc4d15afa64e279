// Where the pictures go: names decided and places tried before a ray is traced, files written whole or not at all.
#pragma once

#include "cli/exit_code.h"
#include "renderer/image/image_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace isl::cli {

/// What is wrong with a choice of output files, and whose fault it is.
struct OutputProblem {
  ExitCode code = ExitCode::done;
  std::string message;

  [[nodiscard]] bool none() const { return code == ExitCode::done; }
};

/// `asked`, or `<scene name>.png` in the current folder.
[[nodiscard]] std::vector<std::filesystem::path> output_files(const std::vector<std::filesystem::path>& asked,
                                                              const std::string& scene_name);

/// Formats known, no file twice, each place writable. Creates and changes nothing that stays.
[[nodiscard]] OutputProblem check_outputs(const std::vector<std::filesystem::path>& files);

/// Whether a file can be written there; for what is no picture.
[[nodiscard]] OutputProblem check_place(const std::filesystem::path& file);

/// A layer's own picture, beside the picture.
struct LayerFile {
  std::filesystem::path file;
  std::string layer;
};

/// `NAME.LAYER.EXT` for every NAME.EXT that holds no layers itself, and every layer that has a picture.
[[nodiscard]] std::vector<LayerFile> layer_files(const std::vector<std::filesystem::path>& files,
                                                 const std::vector<std::string>& layers);

/// `NAME.partial.EXT` for `NAME.EXT`: where an interrupted picture goes.
[[nodiscard]] std::filesystem::path partial_name(const std::filesystem::path& file);

/// Writes the picture to each file; goes on after a failure, and tells the first.
[[nodiscard]] OutputProblem write_outputs(const std::vector<std::filesystem::path>& files, const render::Image& image,
                                          const render::ImageFileOptions& options);

/// Replaces a text file as a whole.
[[nodiscard]] OutputProblem write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace isl::cli
