// Patterns that depend on the surface, as in POV-Ray: on its normal in the world, bent by the bumps of the layer, and
// on the direction of the view. Where there is no surface, as in functions and the sky, they are 0. `average` is here,
// too: it needs no value, because all entries of its map are used.
#include "renderer/patterns/kinds/pattern_kind.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

constexpr PatternHosts kSurfaces{.function = false};
/// The angle between the normal and `direction` (or the direction to the point `reference`), from low to high as 0 to
/// 1; and with an altitude a weighted mean with the height along it, the weights being the vectors' lengths.
struct Slope {
  bool is_reference = false, is_direction = true;  ///< which of the two is given
  Vec3 direction{0}, reference{0};
  double low_slope = 0, high_slope = 1;
  bool has_altitude = false;
  Vec3 altitude{0};
  double low_altitude = 0, high_altitude = 1;
};

void read_range(scene::OperandReader& reader, double& low, double& high, std::string_view low_name,
                std::string_view high_name) noexcept {
  if (!reader.accept_comma() && !reader.is_value_next()) return;
  low = reader.number(low_name);
  reader.accept_comma();
  high = reader.number(high_name);
}

void read_slope(scene::OperandReader& reader, Slope& slope, std::string_view word) noexcept {
  slope.is_reference = reader.accept_word("point_at");
  slope.is_direction = !slope.is_reference;
  (slope.is_reference ? slope.reference : slope.direction) = reader.vector("a direction");
  if (slope.is_direction && slope.direction.length() == 0)
    reader.fail("the direction of `slope` must not be <0, 0, 0>");
  // Without braces, a number that follows is the size of the host's bumps.
  if (!reader.is_in_block(word)) return;
  read_range(reader, slope.low_slope, slope.high_slope, "the low slope", "the high slope");
  slope.has_altitude = reader.accept_word("altitude");
  if (!slope.has_altitude) return;
  if (slope.is_reference) reader.fail("`altitude` cannot be used with `point_at`");
  slope.altitude = reader.vector("a vector after `altitude`");
  read_range(reader, slope.low_altitude, slope.high_altitude, "the low altitude", "the high altitude");
}

double in_range(double value, double low, double high) { return high == low ? value : (value - low) / (high - low); }

/// The angle to a plane across a direction, as a share of a turn by half: 0 against the direction, 1 along it.
double share_of_angle(double cosine) { return std::asin(std::clamp(cosine, -1.0, 1.0)) / std::numbers::pi + 0.5; }

/// `point_at` is a place in the world; the altitude is that of the point in the pattern's own space.
double slope_value(const PatternPoint& at) noexcept {
  const values::SurfaceView* const surface = at.environment.surface();
  if (!surface) return 0;
  const auto& slope = at.operands<Slope>();
  const Vec3 way = slope.is_reference ? slope.reference - *surface->point : slope.direction;
  const double length = way.length();
  const double angle = length > 0 ? share_of_angle(surface->normal->dot(way) / length) : 0.5;
  const double value = in_range(angle, slope.low_slope, slope.high_slope);
  if (!slope.has_altitude) return below_1(value);
  const double altitude = slope.altitude.length();
  if (!(altitude > 0)) return below_1(value);
  const double height = in_range(at.point.dot(slope.altitude) / altitude, slope.low_altitude, slope.high_altitude);
  return below_1((length * value + altitude * height) / (length + altitude));
}

/// From ½ where the view grazes the surface to 1 where it is perpendicular to it.
double aoi_value(const PatternPoint& at) noexcept {
  const values::SurfaceView* const surface = at.environment.surface();
  return surface ? share_of_angle(-surface->normal->dot(*surface->direction)) : 0;
}

using Numbers = std::vector<std::variant<double, int>>;
Numbers slopes_of(const Slope& slope) { return {slope.low_slope, slope.high_slope}; }
Numbers altitudes_of(const Slope& slope) { return {slope.low_altitude, slope.high_altitude}; }
constexpr scene::OperandField kSlope[] = {
    scene::operand<&Slope::direction>("direction").dumped_with<&Slope::is_direction>(),
    scene::operand<&Slope::reference>("point_at").dumped_with<&Slope::is_reference>(),
    scene::dumped<Slope, slopes_of>("slope"),
    scene::operand<&Slope::altitude>("altitude").dumped_with<&Slope::has_altitude>(),
    scene::dumped<Slope, altitudes_of>("altitudes").dumped_with<&Slope::has_altitude>()};

}  // namespace

constinit const PatternInfo pattern_kinds::aoi{.hosts = kSurfaces, .value = aoi_value};
constinit const PatternInfo pattern_kinds::average{.hosts = kSurfaces, .choice = PatternChoice::mean_of_map};
constinit const PatternInfo pattern_kinds::slope{.block = PatternBlock::optional,
                                                 .hosts = kSurfaces,
                                                 .operands = operands_of<Slope, kSlope>,
                                                 .read = read_operands<Slope, read_slope>,
                                                 .value = slope_value};

}  // namespace isl::render
