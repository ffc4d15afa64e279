#include "cli/output/output_files.h"

#include "cli/output/standard_output.h"

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

/// One path for all names of a place, as far as it can be determined for a file that need not exist.
fs::path identity(const fs::path& file) {
  if (!standard_output_format(file).empty()) return ":-";
  std::error_code error;
  fs::path canonical = fs::weakly_canonical(fs::absolute(file, error), error);
  return error ? file : canonical;
}

OutputProblem check_standard_output(const std::string& output) {
  if (standard_output_is_terminal()) {
    return {ExitCode::command_line_error,
            fmt::format("-o {}: standard output is a terminal; send it to a file or into a pipe", output)};
  }
  return file_problem(why_no_standard_output());
}

}  // namespace

std::vector<fs::path> output_files(const std::vector<fs::path>& asked, const std::string& scene_name) {
  if (!asked.empty()) return asked;
  return {scene_name + ".png"};
}

std::string output_format(const fs::path& output) {
  std::string format = standard_output_format(output);
  return format.empty() ? render::image_format_of(output.string()) : format;
}

std::string display_name(const fs::path& output) {
  return standard_output_format(output).empty() ? output.string() : "standard output";
}

OutputProblem check_outputs(const std::vector<fs::path>& files) {
  std::vector<fs::path> seen;
  for (const fs::path& file : files) {
    if (output_format(file).empty()) {
      return {ExitCode::command_line_error,
              fmt::format("{}: the format is unknown; the formats are {}, and `png:-` for standard output",
                          file.string(), render::kImageFormats)};
    }
    fs::path same = identity(file);
    if (std::find(seen.begin(), seen.end(), same) != seen.end()) {
      return {ExitCode::command_line_error, fmt::format("{}: the output is named twice", display_name(file))};
    }
    seen.push_back(std::move(same));
  }
  for (const fs::path& file : files) {
    OutputProblem problem =
        standard_output_format(file).empty() ? check_place(file) : check_standard_output(file.string());
    if (!problem.none()) return problem;
  }
  return {};
}

OutputProblem check_place(const fs::path& file) { return file_problem(render::why_not_writable(file.string())); }

std::vector<LayerFile> layer_files(const std::vector<fs::path>& files, const render::Aovs& layers) {
  std::vector<LayerFile> result;
  for (const fs::path& file : files) {
    if (output_format(file) == "exr" || !standard_output_format(file).empty()) continue;
    for (const render::Aov* const layer : layers) {
      if (layer->picture.kind == render::AovPicture::Kind::none) continue;
      const std::string name = fmt::format("{}.{}{}", file.stem().string(), layer->name, file.extension().string());
      result.push_back({file.parent_path() / name, layer});
    }
  }
  return result;
}

std::vector<fs::path> partial_names(const std::vector<fs::path>& files) {
  std::vector<fs::path> names;
  for (const fs::path& file : files) {
    if (!standard_output_format(file).empty()) continue;
    names.push_back(file.parent_path() / (file.stem().string() + ".partial" + file.extension().string()));
  }
  return names;
}

void OutputWriter::note(std::string problem) {
  if (first_.none()) first_ = file_problem(std::move(problem));
}

void OutputWriter::add(const fs::path& output, const render::Image& image) {
  render::EncodedFile encoded = render::encode_image(image, output_format(output), options_);
  if (!encoded.error.empty()) {
    note(fmt::format("cannot write {}: {}", display_name(output), encoded.error));
  } else if (!standard_output_format(output).empty()) {
    standard_output_ = std::move(encoded.bytes);
  } else {
    render::StagedFile file(output.string(), encoded.bytes);
    note(file.error());
    if (file.error().empty()) staged_.push_back(std::move(file));
  }
}

OutputProblem OutputWriter::finish() {
  for (render::StagedFile& file : staged_) note(file.take_place());
  note(write_standard_output(standard_output_));
  return first_;
}

OutputProblem write_text(const fs::path& file, const std::string& text) {
  const std::span<const unsigned char> bytes(reinterpret_cast<const unsigned char*>(text.data()), text.size());
  return file_problem(render::write_atomically(file.string(), bytes));
}

}  // namespace isl::cli
