#include "interpreter/readers/supported.h"

#include <algorithm>
#include <array>

namespace isl::interpreter {
namespace {

using namespace grammar::word;

constexpr auto kSupported = std::to_array<grammar::Symbol>({
    // Objects, lights, camera, settings.
    kw_blob,
    kw_sphere,
    kw_cylinder,
    kw_cone,
    kw_plane,
    kw_union,
    kw_object,
    kw_light_source,
    kw_camera,
    kw_background,
    kw_global_settings,
    // What stands in them.
    kw_component,
    kw_threshold,
    kw_strength,
    kw_sturm,
    kw_hierarchy,
    kw_open,
    kw_split_union,
    kw_shadowless,
    kw_media_attenuation,
    kw_media_interaction,
    kw_location,
    kw_look_at,
    kw_angle,
    kw_right,
    kw_up,
    kw_sky,
    kw_direction,
    kw_perspective,
    kw_assumed_gamma,
    kw_ambient_light,
    kw_max_trace_level,
    kw_adc_bailout,
    kw_charset,
    kw_max_intersections,
    kw_number_of_waves,
    kw_irid_wavelength,
    kw_hf_gray_16,
    kw_mm_per_unit,
    // Modifiers.
    kw_translate,
    kw_rotate,
    kw_scale,
    kw_matrix,
    kw_transform,
    kw_inverse,
    kw_no_shadow,
    kw_hollow,
    kw_bounded_by,
    kw_texture,
    kw_pigment,
    kw_finish,
    kw_quick_color,
    kw_quick_colour,
    kw_ambient,
    kw_diffuse,
    kw_brilliance,
    kw_phong,
    kw_phong_size,
    kw_specular,
    kw_roughness,
    // Colours.
    kw_color,
    kw_colour,
    kw_rgb,
    kw_rgbf,
    kw_rgbt,
    kw_rgbft,
    kw_srgb,
    kw_srgbf,
    kw_srgbt,
    kw_srgbft,
    kw_red,
    kw_green,
    kw_blue,
    kw_filter,
    kw_transmit,
    kw_gray,
});

}  // namespace

bool is_supported_word(grammar::Symbol word) { return std::ranges::find(kSupported, word) != kSupported.end(); }

}  // namespace isl::interpreter
