#include "cli/output/output_files.h"

#include "cli/output/standard_output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <utility>

namespace isl::cli {

namespace fs = std::filesystem;

namespace {

OutputProblem file_problem(std::string message) {
  if (message.empty()) return {};
  return {ExitCode::file_error, std::move(message)};
}

/// Standard output that goes to a file is that file; two pictures in any other stream would be one.
FileIdentity identity_of_output(const fs::path& output) {
  if (standard_output_format(output).empty()) return identity_of(output);
  return identity_of_stream(STDOUT_FILENO).value_or(FileIdentity{"/dev/stdout"});
}

OutputProblem clash(const OutputPlace& place, const FileRegister::Entry& other) {
  return {ExitCode::command_line_error,
          other.is_output() ? fmt::format("{} and {} are one file; give each a file of its own", other.role, place.role)
                            : fmt::format("{}: this file is {}; choose another name", place.role, other.role)};
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

OutputProblem check_pictures(const std::vector<fs::path>& pictures) {
  for (const fs::path& picture : pictures) {
    if (!output_format(picture).empty()) continue;
    return {ExitCode::command_line_error,
            fmt::format("{}: the format is unknown; the formats are {}, and `png:-` for standard output",
                        picture.string(), render::kImageFormats)};
  }
  return {};
}

OutputProblem claim(OutputSet& outputs, const std::vector<OutputPlace>& places) {
  for (const OutputPlace& place : places) {
    const FileRegister::Entry* const other = outputs.files().add_output(identity_of_output(place.file), place.role);
    if (other != nullptr) return clash(place, *other);
  }
  for (const OutputPlace& place : places) {
    OutputProblem problem = standard_output_format(place.file).empty()
                                ? file_problem(outputs.why_not_writable(place.file))
                                : check_standard_output(place.file.string());
    if (!problem.none()) return problem;
  }
  return {};
}

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
  if (!problem.empty()) problems_.push_back(std::move(problem));
}

void OutputWriter::add(const fs::path& output, const render::Image& image, const render::ImageFileOptions& options) {
  render::EncodedFile encoded = render::encode_image(image, output_format(output), options);
  if (!encoded.error.empty()) {
    note(fmt::format("cannot write {}: {}", display_name(output), encoded.error));
  } else if (!standard_output_format(output).empty()) {
    standard_output_ = std::move(encoded.bytes);
  } else {
    note(outputs_.stage(output, encoded.bytes));
  }
}

void OutputWriter::add_text(const fs::path& file, std::string_view text) {
  note(outputs_.stage(file, {reinterpret_cast<const unsigned char*>(text.data()), text.size()}));
}

std::vector<std::string> OutputWriter::finish() {
  for (std::string& problem : outputs_.commit()) note(std::move(problem));
  note(write_standard_output(standard_output_));
  return std::move(problems_);
}

}  // namespace isl::cli
