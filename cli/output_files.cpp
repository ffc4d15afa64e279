#include "cli/output_files.h"

#include "renderer/image/atomic_file.h"
#include "renderer/image/layer_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <system_error>

namespace isl::cli {

namespace fs = std::filesystem;

namespace {

OutputProblem file_problem(std::string message) {
  if (message.empty()) return {};
  return {ExitCode::file_error, std::move(message)};
}

/// The same for all names of one file, as far as that can be told of one that need not exist.
fs::path identity(const fs::path& file) {
  std::error_code error;
  fs::path canonical = fs::weakly_canonical(fs::absolute(file, error), error);
  return error ? file : canonical;
}

}  // namespace

std::vector<fs::path> output_files(const std::vector<fs::path>& asked, const std::string& scene_name) {
  if (!asked.empty()) return asked;
  return {scene_name + ".png"};
}

OutputProblem check_outputs(const std::vector<fs::path>& files) {
  std::vector<fs::path> seen;
  for (const fs::path& file : files) {
    if (render::image_format_of(file.string()).empty()) {
      return {ExitCode::command_line_error,
              fmt::format("{}: the name says no known format; there are {}", file.string(), render::kImageFormats)};
    }
    fs::path same = identity(file);
    if (std::find(seen.begin(), seen.end(), same) != seen.end()) {
      return {ExitCode::command_line_error, fmt::format("{}: named twice as an output", file.string())};
    }
    seen.push_back(std::move(same));
  }
  for (const fs::path& file : files) {
    if (OutputProblem problem = check_place(file); !problem.none()) return problem;
  }
  return {};
}

OutputProblem check_place(const fs::path& file) { return file_problem(render::why_not_writable(file.string())); }

std::vector<LayerFile> layer_files(const std::vector<fs::path>& files, const std::vector<std::string>& layers) {
  std::vector<LayerFile> result;
  for (const fs::path& file : files) {
    if (render::image_format_of(file.string()) == "exr") continue;
    for (const std::string& layer : layers) {
      if (!render::is_pictured_layer(layer)) continue;
      result.push_back({file.parent_path() / (file.stem().string() + "." + layer + file.extension().string()), layer});
    }
  }
  return result;
}

fs::path partial_name(const fs::path& file) {
  return file.parent_path() / (file.stem().string() + ".partial" + file.extension().string());
}

OutputProblem write_outputs(const std::vector<fs::path>& files, const render::Image& image,
                            const render::ImageFileOptions& options) {
  OutputProblem first;
  for (const fs::path& file : files) {
    OutputProblem problem = file_problem(render::write_image(image, file.string(), options));
    if (first.none()) first = std::move(problem);
  }
  return first;
}

OutputProblem write_text(const fs::path& file, const std::string& text) {
  const std::span<const unsigned char> bytes(reinterpret_cast<const unsigned char*>(text.data()), text.size());
  return file_problem(render::write_atomically(file.string(), bytes));
}

}  // namespace isl::cli
