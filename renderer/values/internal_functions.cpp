#include "renderer/values/internal_functions.h"

#include "renderer/values/multifractals.h"
#include "renderer/values/noise.h"
#include "renderer/values/polynomials.h"
#include "renderer/values/surfaces.h"

namespace isl::values {
namespace {

double generated_noise(const double* p) { return noise({p[0], p[1], p[2]}, noise_generator_of(p[3])); }

constexpr InternalFunction kFunctions[] = {
    {"f_algbr_cyl1", 5},
    {"f_algbr_cyl2", 5},
    {"f_algbr_cyl3", 5},
    {"f_algbr_cyl4", 5},
    {"f_bicorn", 2},
    {"f_bifolia", 2},
    {"f_blob", 5},
    {"f_blob2", 4},
    {"f_boy_surface", 2},
    {"f_comma", 1},
    {"f_cross_ellipsoids", 4},
    {"f_crossed_trough", 1, crossed_trough},
    {"f_cubic_saddle", 1, cubic_saddle},
    {"f_cushion", 1, cushion},
    {"f_devils_curve", 1, devils_curve},
    {"f_devils_curve_2d", 6},
    {"f_dupin_cyclid", 6},
    {"f_ellipsoid", 3, ellipsoid},
    {"f_enneper", 1},
    {"f_flange_cover", 4},
    {"f_folium_surface", 3},
    {"f_folium_surface_2d", 6},
    {"f_glob", 1, glob},
    {"f_heart", 1, heart},
    {"f_helical_torus", 10},
    {"f_helix1", 7, helix_1},
    {"f_helix2", 7, helix_2},
    {"f_hex_x", 1},
    {"f_hex_y", 1},
    {"f_hetero_mf", 6, heterogeneous_multifractal},
    {"f_hunt_surface", 1, hunt_surface},
    {"f_hyperbolic_torus", 3},
    {"f_isect_ellipsoids", 4},
    {"f_kampyle_of_eudoxus", 3},
    {"f_kampyle_of_eudoxus_2d", 6},
    {"f_klein_bottle", 1, klein_bottle},
    {"f_kummer_surface_v1", 1, kummer_surface_1},
    {"f_kummer_surface_v2", 4},
    {"f_lemniscate_of_gerono", 1, lemniscate_of_gerono},
    {"f_lemniscate_of_gerono_2d", 6},
    {"f_mesh1", 5},
    {"f_mitre", 1, mitre},
    {"f_nodal_cubic", 1, nodal_cubic},
    {"f_odd", 1, cushion},
    {"f_ovals_of_cassini", 4},
    {"f_paraboloid", 1, paraboloid},
    {"f_parabolic_torus", 3},
    {"f_ph", 0, polar_angle},
    {"f_pillow", 1, pillow},
    {"f_piriform", 1, piriform},
    {"f_piriform_2d", 7},
    {"f_poly4", 5},
    {"f_polytubes", 6},
    {"f_quantum", 1},
    {"f_quartic_paraboloid", 1, quartic_paraboloid},
    {"f_quartic_saddle", 1, quartic_saddle},
    {"f_quartic_cylinder", 3},
    {"f_r", 0, radius},
    {"f_ridge", 6},
    {"f_ridged_mf", 6, ridged_multifractal},
    {"f_rounded_box", 4, rounded_box},
    {"f_sphere", 1, sphere},
    {"f_spikes", 5},
    {"f_spikes_2d", 4},
    {"f_spiral", 6},
    {"f_steiners_roman", 1, steiners_roman},
    {"f_strophoid", 4},
    {"f_strophoid_2d", 7},
    {"f_superellipsoid", 2, superellipsoid},
    {"f_th", 0, azimuth},
    {"f_torus", 2, torus},
    {"f_torus2", 3},
    {"f_torus_gumdrop", 1, torus_gumdrop},
    {"f_umbrella", 1, umbrella},
    {"f_witch_of_agnesi", 2},
    {"f_witch_of_agnesi_2d", 6},
    {"f_noise3d", 0, generated_noise, true},
    {},
    {"f_noise_generator", 1, generated_noise},
};

}  // namespace

std::span<const InternalFunction> internal_functions() noexcept { return kFunctions; }

}  // namespace isl::values
