// Patterns: functions of the point (and for some of the surface) with values from 0 to 1, by which pigments, normals
// and textures choose from their maps. A record says which and with what operands; renderer/patterns evaluates it.
#pragma once

#include "base/source_span.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/warp.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace isl::scene {

/// POV-Ray's patterns, by its names. `plain` is no pattern: the same everywhere. `image_map` and `bump_map` take their
/// values from an Image, `material_map` its choice.
enum class PatternKind : std::uint8_t {
  plain,
  agate,
  aoi,
  average,
  boxed,
  bozo,
  brick,
  bump_map,
  bumps,
  cells,
  checker,
  crackle,
  cubic,
  cylindrical,
  density_file,
  dents,
  facets,
  fractal,
  function,
  gradient,
  granite,
  hexagon,
  image_map,
  image_pattern,
  leopard,
  marble,
  material_map,
  object,
  onion,
  pavement,
  pigment_pattern,
  planar,
  quilted,
  radial,
  ripples,
  slope,
  spherical,
  spiral1,
  spiral2,
  spotted,
  square,
  tiling,
  triangular,
  waves,
  wood,
  wrinkles,
};

/// Of a pattern that does not say. What chooses from a list is not scaled: 0 leaves the item's number as it is.
[[nodiscard]] constexpr double default_frequency(PatternKind kind) {
  switch (kind) {
    case PatternKind::brick:
    case PatternKind::checker:
    case PatternKind::cubic:
    case PatternKind::hexagon:
    case PatternKind::object:
    case PatternKind::quilted:
    case PatternKind::square:
    case PatternKind::triangular: return 0;
    default: return 1;
  }
}

/// How the value v of a pattern goes up and down: as fmod(v · frequency + phase, 1) through the wave.
enum class Wave : std::uint8_t { ramp, triangle, sine, scallop, cubic, poly };

struct AgateOperands {
  double turbulence = 1;
};
struct BrickOperands {
  Vec3 size{8, 3, 4.5};
  double mortar = 0.5;
};
struct CrackleOperands {
  Vec3 form{-1, 1, 0};  ///< weights of the distances to the nearest three points
  double metric = 2;
  double offset = 0;
  bool is_solid = false;
};
struct DensityFileOperands {
  std::string file;
  int interpolate = 0;
};
/// Exactly one of both is above 0: facets of that size in space, or of the normal.
struct FacetsOperands {
  double coords = 0;
  double size = 0;
};
/// z ↦ z^exponent + c or a magnet of type 1 or 2, from z = 0 (mandel) or the point (julia).
struct FractalOperands {
  bool is_julia = false;
  int magnet = 0;                  ///< 0: none
  double real = 0, imaginary = 0;  ///< c of a Julia set
  double iterations = 0;
  int exponent = 2;
  int exterior_type = 1;
  double exterior_factor = 1;
  int interior_type = 0;
  double interior_factor = 1;
};
struct FunctionOperands {
  FunctionId function = kNoFunction;
};
struct GradientOperands {
  Vec3 direction{0};  ///< unit length, or 0
};
/// The first item of the map outside the object, the second inside. An index into Database::pattern_objects.
struct ObjectOperands {
  std::uint32_t object = kNone;
};
struct PavementOperands {
  int sides = 3;
  int tiles = 1;
  int pattern = 1;
  int form = 0;
  int interior = 0;
  int exterior = 0;
};
struct PigmentOperands {
  PigmentId pigment{};
};
struct QuiltedOperands {
  double control0 = 1;
  double control1 = 1;
};
/// The angle between the normal and `direction` (or the direction to `reference`), from low to high as 0 to 1; and with
/// an altitude a weighted mean with the height along it, the weights being the vectors' lengths.
struct SlopeOperands {
  Vec3 direction{0};
  bool is_reference = false;  ///< `point_at`: direction is a point
  double low_slope = 0, high_slope = 1;
  bool has_altitude = false;
  Vec3 altitude{0};
  double low_altitude = 0, high_altitude = 1;
};
struct SpiralOperands {
  int arms = 0;
};
struct TilingOperands {
  int number = 1;
};

/// By kind; std::monostate where a pattern has none. ImageId: image_map, bump_map, image_pattern, material_map.
using PatternOperands =
    std::variant<std::monostate, AgateOperands, BrickOperands, CrackleOperands, DensityFileOperands, FacetsOperands,
                 FractalOperands, FunctionOperands, GradientOperands, ImageId, ObjectOperands, PavementOperands,
                 PigmentOperands, QuiltedOperands, SlopeOperands, SpiralOperands, TilingOperands>;

struct Pattern {
  PatternKind kind = PatternKind::plain;
  Wave wave = Wave::ramp;
  bool uv_mapping = false;           ///< the point is (u, v, 0) of the surface; objects' transforms do not move it
  std::uint8_t noise_generator = 0;  ///< 0: the scene's
  double exponent = 1;               ///< of Wave::poly
  double frequency = 1;
  double phase = 0;
  Turbulence turbulence;    ///< applied last of all, in the pattern's own space, wherever it was written
  std::vector<Warp> warps;  ///< in the order of writing: the point meets the last one first
  PatternOperands operands;
  OriginId said_at{};
};

}  // namespace isl::scene
