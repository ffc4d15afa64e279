#include "interpreter/readers/supported.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace isl::interpreter {
namespace {

using namespace grammar::word;

constexpr auto kObjects = std::to_array<grammar::Symbol>({
    kw_bicubic_patch,
    kw_height_field,
    kw_isosurface,
    kw_julia_fractal,
    kw_lathe,
    kw_mesh,
    kw_mesh2,
    kw_ovus,
    kw_parametric,
    kw_prism,
    kw_sor,
    kw_sphere_sweep,
    kw_text,
});

constexpr auto kOthers = std::to_array<grammar::Symbol>({
    kw_density,
    kw_density_map,
    kw_media,
    kw_mesh_camera,
    kw_photons,
    kw_radiosity,
    kw_subsurface,
});

/// They are no words here, because scenes of 3.7 may use them as names.
constexpr auto kNewer = std::to_array<std::string_view>(
    {"blend_gamma", "blend_mode", "dictionary", "lemon", "mixed", "optional", "polarity", "potential", "user_defined"});

}  // namespace

bool is_newer_word(std::string_view name) { return std::ranges::find(kNewer, name) != kNewer.end(); }

std::string newer_word_message(std::string_view name) {
  return fmt::format("`{}` came with version 3.8 of the language, which is not known here", name);
}

bool is_unsupported_object(grammar::Symbol word) { return std::ranges::find(kObjects, word) != kObjects.end(); }

bool is_unsupported_word(grammar::Symbol word) {
  return is_unsupported_object(word) || std::ranges::find(kOthers, word) != kOthers.end();
}

}  // namespace isl::interpreter
