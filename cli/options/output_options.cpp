#include "cli/options/output_options.h"

#include "cli/output/output_files.h"
#include "cli/output/standard_output.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::cli {
namespace {

namespace fs = std::filesystem;

/// Without a file name the output is a PNG, which has both depths.
std::optional<OutputComplaint> check_bits(const PictureOptions& picture) {
  if (picture.bits == 0 || picture.outputs.empty()) return std::nullopt;
  std::string linear;  // an output whose format has no choice of bits
  bool has_any = false;
  for (const fs::path& output : picture.outputs) {
    const std::string format = output_format(output);
    if (format.empty()) continue;  // another check reports its name
    if (render::is_linear_format(format)) {
      linear = format;
    } else if (render::format_holds_bits(format, picture.bits)) {
      has_any = true;
    } else {
      return OutputComplaint{fmt::format("--bits: {} has 8 bits a channel, not {}", format, picture.bits),
                             "png and tif have 8 or 16"};
    }
  }
  if (has_any || linear.empty()) return std::nullopt;
  return OutputComplaint{fmt::format("--bits: {} holds floating-point numbers only", linear),
                         "png and tif have 8 or 16 bits a channel"};
}

std::optional<OutputComplaint> check_layers(const PictureOptions& picture) {
  const auto has_picture = [](const render::Aov* layer) {
    return layer->picture.kind != render::AovPicture::Kind::none;
  };
  const auto is_exr = [](const fs::path& output) { return output_format(output) == "exr"; };
  if (!std::all_of(picture.layers.begin(), picture.layers.end(), has_picture) &&
      std::none_of(picture.outputs.begin(), picture.outputs.end(), is_exr)) {
    return OutputComplaint{"--aov: only an .exr file holds layers", "add `-o NAME.exr`"};
  }
  const auto holds_none = [&](const fs::path& output) {
    return !is_exr(output) && !standard_output_format(output).empty();
  };
  if (!picture.layers.empty() && !picture.outputs.empty() &&
      std::all_of(picture.outputs.begin(), picture.outputs.end(), holds_none)) {
    return OutputComplaint{"--aov: standard output takes one picture, without the layers",
                           "`-o exr:-` holds the layers, and a file's name has their pictures beside it"};
  }
  return std::nullopt;
}

std::optional<OutputComplaint> check_standard_output(const PictureOptions& picture, OutputFormat format) {
  for (const fs::path& output : picture.outputs) {
    if (output == "-")
      return OutputComplaint{"-o -: the format of standard output is missing", "write it as in `-o png:-`"};
    if (format == OutputFormat::json && !standard_output_format(output).empty()) {
      return OutputComplaint{fmt::format("-o {}: --format json needs standard output for itself", output.string()),
                             "write the picture to a file"};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<OutputComplaint> check_output_options(const PictureOptions& picture, OutputFormat format) {
  if (auto complaint = check_standard_output(picture, format)) return complaint;
  if (auto complaint = check_layers(picture)) return complaint;
  return check_bits(picture);
}

}  // namespace isl::cli
