#include "interpreter/readers/words/supported.h"

#include <algorithm>
#include <array>

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
    kw_parametric,
    kw_sor,
    kw_sphere_sweep,
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

}  // namespace

bool is_unsupported_object(grammar::Symbol word) { return std::ranges::find(kObjects, word) != kObjects.end(); }

bool is_unsupported_word(grammar::Symbol word) {
  return is_unsupported_object(word) || std::ranges::find(kOthers, word) != kOthers.end();
}

}  // namespace isl::interpreter
