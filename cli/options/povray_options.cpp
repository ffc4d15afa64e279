#include "cli/options/povray_options.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace isl::cli {
namespace {

/// Longer letters first, because the value follows without a blank.
constexpr std::array kOptions = std::to_array<PovrayOption>({
    {"RTR", "real_time_raytracing"},
    {"KFI", "initial_frame"},
    {"KFF", "final_frame"},
    {"KI", "initial_clock"},
    {"KF", "final_clock"},
    {"KC", "cyclic_animation"},
    {"SF", "subset_start_frame"},
    {"EF", "subset_end_frame"},
    {"SC", "start_column"},
    {"SR", "start_row"},
    {"EC", "end_column"},
    {"ER", "end_row"},
    {"SP", "preview_start_size"},
    {"EP", "preview_end_size"},
    {"SU", "split_unions"},
    {"UA", "output_alpha"},
    {"UD", "draw_vistas"},
    {"UF", "field_render"},
    {"UL", "light_buffer"},
    {"UO", "odd_field"},
    {"UR", "remove_bounds"},
    {"UV", "vista_buffer"},
    {"WT", "work_threads", "-t"},
    {"WL", "warning_level"},
    {"AM", "sampling_method"},
    {"AC", "antialias_confidence"},
    {"AG", "antialias_gamma"},
    {"BM", "bounding_method"},
    {"BP", "render_block_step"},
    {"BS", "render_block_size"},
    {"HI", "include_header"},
    {"HR", "high_reproducibility"},
    {"MB", "bounding_threshold"},
    {"MI", "max_image_buffer_memory"},
    {"MV", "version"},
    {"RF", "radiosity_file_name"},
    {"RP", "render_pattern"},
    {"SS", "stochastic_seed"},
    {"TH", "dither_method"},
    {"GA", "all_console"},
    {"GD", "debug_console"},
    {"GF", "fatal_console"},
    {"GI", "create_ini"},
    {"GR", "render_console"},
    {"GS", "statistic_console"},
    {"GW", "warning_console"},
    {"PF", "post_frame_command"},
    {"PS", "post_scene_command"},
    {"I", "input_file_name"},
    {"O", "output_file_name"},
    {"W", "width"},
    {"H", "height"},
    {"A", "antialias_threshold"},
    {"Q", "quality", "--quality"},
    {"L", "library_path", "-I"},
    {"K", "clock", "--clock"},
    {"F", "output_file_type"},
    {"R", "antialias_depth"},
    {"J", "jitter_amount"},
    {"D", "display"},
    {"P", "pause_when_done"},
    {"V", "verbose"},
    {"C", "continue_trace"},
    {"B", "buffer_output"},
    {"X", "test_abort"},
    {"", "declare", "-D"},
    {"", "all_file"},
    {"", "antialias"},
    {"", "bits_per_color"},
    {"", "bits_per_colour"},
    {"", "bounding"},
    {"", "buffer_size"},
    {"", "clockless_animation"},
    {"", "compression"},
    {"", "create_continue_trace_log"},
    {"", "debug_file"},
    {"", "display_gamma"},
    {"", "dither"},
    {"", "fatal_error_command"},
    {"", "fatal_error_return"},
    {"", "fatal_file"},
    {"", "file_gamma"},
    {"", "frame_step"},
    {"", "grayscale_output"},
    {"", "include_ini"},
    {"", "jitter"},
    {"", "output_to_file"},
    {"", "palette"},
    {"", "post_frame_return"},
    {"", "post_scene_return"},
    {"", "pre_frame_command"},
    {"", "pre_frame_return"},
    {"", "pre_scene_command"},
    {"", "pre_scene_return"},
    {"", "radiosity_from_file"},
    {"", "radiosity_to_file"},
    {"", "radiosity_vain_pretrace"},
    {"", "render_file"},
    {"", "statistic_file"},
    {"", "test_abort_count"},
    {"", "user_abort_command"},
    {"", "user_abort_return"},
    {"", "video_mode"},
    {"", "warning_file"},
});

bool starts_with_letters(std::string_view text, std::string_view letters) {
  return !letters.empty() && text.size() >= letters.size() &&
         std::equal(letters.begin(), letters.end(), text.begin(),
                    [](char a, char b) { return a == std::toupper(static_cast<unsigned char>(b)); });
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

std::span<const PovrayOption> povray_options() { return kOptions; }

const PovrayOption* povray_option(std::string_view key) {
  const auto* const row = std::ranges::find(kOptions, lower_case(key), &PovrayOption::key);
  return row == kOptions.end() ? nullptr : row;
}

std::optional<PovraySetting> povray_switch(std::string_view text) {
  if (text.size() < 2 || (text[0] != '+' && text[0] != '-')) return std::nullopt;
  for (const PovrayOption& option : kOptions) {
    if (starts_with_letters(text.substr(1), option.letters)) {
      return PovraySetting{&option, std::string(text.substr(1 + option.letters.size())), text[0] == '+'};
    }
  }
  return std::nullopt;
}

std::string_view extension_of_povray_type(std::string_view type) {
  switch (type.empty() ? 'N' : static_cast<char>(std::toupper(static_cast<unsigned char>(type.front())))) {
    case 'N': return ".png";
    case 'P': return ".ppm";
    case 'J': return ".jpg";
    case 'E': return ".exr";
    case 'H': return ".hdr";
    default: return "";
  }
}

}  // namespace isl::cli
