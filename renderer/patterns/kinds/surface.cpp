// Patterns that need more of a surface than a point. They are not evaluated yet, except `average`, which needs no
// value: all entries of its map are used. In functions the others are 0, as in POV-Ray.
#include "renderer/patterns/kinds/pattern_kind.h"

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

void read_slope(scene::OperandReader& reader, Slope& slope, std::string_view /*word*/) noexcept {
  slope.is_reference = reader.accept_word("point_at");
  slope.is_direction = !slope.is_reference;
  (slope.is_reference ? slope.reference : slope.direction) = reader.vector("a direction");
  if (slope.is_direction && slope.direction.length() == 0)
    reader.fail("the direction of `slope` must not be <0, 0, 0>");
  read_range(reader, slope.low_slope, slope.high_slope, "the low slope", "the high slope");
  slope.has_altitude = reader.accept_word("altitude");
  if (!slope.has_altitude) return;
  if (slope.is_reference) reader.fail("`altitude` cannot be used with `point_at`");
  slope.altitude = reader.vector("a vector after `altitude`");
  read_range(reader, slope.low_altitude, slope.high_altitude, "the low altitude", "the high altitude");
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

constinit const PatternInfo pattern_kinds::aoi{.hosts = kSurfaces, .lack = PatternLack::surface};
constinit const PatternInfo pattern_kinds::average{.hosts = kSurfaces, .choice = PatternChoice::mean_of_map};
constinit const PatternInfo pattern_kinds::slope{.block = PatternBlock::optional,
                                                 .hosts = kSurfaces,
                                                 .operands = operands_of<Slope, kSlope>,
                                                 .read = read_operands<Slope, read_slope>,
                                                 .lack = PatternLack::surface};

}  // namespace isl::render
