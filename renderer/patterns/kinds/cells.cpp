// Patterns of random cells: one number for every unit cube, and Worley's cellular texture ("A Cellular Texture Basis
// Function", SIGGRAPH 1996).
#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/patterns/kinds/random_cubes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

namespace isl::render {
namespace {

/// A point closer than this below a cube counts as in it.
constexpr double kBelowCube = 1e-10;

/// The cube's feature point.
Vec3 point_in(const Cube& cube) noexcept {
  const double* const random = random_numbers(cube);
  return {cube.x + random[0], cube.y + random[1], cube.z + random[2]};
}

/// Distances |d|ⁿ, of points `offset` apart in a fourth dimension, that compare as those of the metric do.
class Metric {
 public:
  Metric(double exponent, double offset) : exponent_(exponent), offset_(term(offset)) {}

  [[nodiscard]] bool is_euclidean() const noexcept { return exponent_ == 2; }
  /// The term of one coordinate.
  [[nodiscard]] double term(double d) const noexcept {
    if (exponent_ == 2) return d * d;
    if (exponent_ == 1) return std::abs(d);
    return std::pow(std::abs(d), exponent_);
  }
  [[nodiscard]] double comparable(const Vec3& d) const noexcept { return term(d.x) + term(d.y) + term(d.z) + offset_; }
  [[nodiscard]] double distance(double comparable) const noexcept {
    if (exponent_ == 2) return std::sqrt(comparable);
    if (exponent_ == 1) return comparable;
    return std::pow(comparable, 1 / exponent_);
  }

 private:
  double exponent_;
  double offset_;
};

/// The nearest three of the feature points that were added.
struct Nearest {
  static constexpr double kFar = std::numeric_limits<double>::max();
  double distances[3] = {kFar, kFar, kFar};  ///< as the metric compares them
  Vec3 point{0};                             ///< the first of them

  void add(double distance, const Vec3& p) noexcept {
    if (distance >= distances[2]) return;
    if (distance < distances[0]) point = p;
    distances[2] = distance;
    if (distances[2] < distances[1]) std::swap(distances[1], distances[2]);
    if (distances[1] < distances[0]) std::swap(distances[0], distances[1]);
  }
};

/// The cubes that can hold one of the nearest points: a block of 5³ without its corners. Along each axis they are, in
/// this order, the point's own, the nearer neighbour, the other one, and the two behind these.
constexpr int kCubes = 5;
constexpr int kStepsAway[kCubes] = {0, 1, 1, 2, 2};
constexpr int kFarthest = 4;  ///< sum of the steps along the axes
/// How far each is away at least, in halves, wherever the point lies in its own cube.
constexpr int kLeastHalves[kCubes] = {0, 0, 1, 2, 3};

struct NearbyCube {
  std::uint8_t place[3] = {};  ///< along each axis, in the order above
  double least_square = 0;     ///< of the distance, at least
};
constexpr std::size_t kNearbyCubes = [] {
  std::size_t count = 0;
  for (const int x : kStepsAway)
    for (const int y : kStepsAway)
      for (const int z : kStepsAway) count += x + y + z <= kFarthest ? 1 : 0;
  return count;
}();
/// Sorted by the least distance, so that a search can end early.
constexpr auto kNearby = [] {
  std::array<NearbyCube, kNearbyCubes> cubes{};
  std::size_t count = 0;
  for (std::uint8_t x = 0; x < kCubes; ++x) {
    for (std::uint8_t y = 0; y < kCubes; ++y) {
      for (std::uint8_t z = 0; z < kCubes; ++z) {
        if (kStepsAway[x] + kStepsAway[y] + kStepsAway[z] > kFarthest) continue;
        int square = 0;
        for (const std::uint8_t place : {x, y, z}) square += kLeastHalves[place] * kLeastHalves[place];
        cubes[count++] = {{x, y, z}, 0.25 * square};
      }
    }
  }
  std::sort(cubes.begin(), cubes.end(), [](const NearbyCube& a, const NearbyCube& b) {
    return std::tie(a.least_square, a.place[0], a.place[1], a.place[2]) <
           std::tie(b.least_square, b.place[0], b.place[1], b.place[2]);
  });
  return cubes;
}();

Nearest find_nearest(const Vec3& p, const Metric& metric) noexcept {
  const Cube home = cube_of(p);
  const int home_of[3] = {home.x, home.y, home.z};
  int steps[3][kCubes];
  double gaps[3][kCubes];  // the least distances of the cubes of each step, as terms of the metric
  for (int axis = 0; axis < 3; ++axis) {
    const int nearer = p[axis] - home_of[axis] < 0.5 ? -1 : 1;
    const int of_axis[kCubes] = {0, nearer, -nearer, 2 * nearer, -2 * nearer};
    for (int i = 0; i < kCubes; ++i) {
      const double low = static_cast<double>(home_of[axis]) + of_axis[i];
      steps[axis][i] = of_axis[i];
      gaps[axis][i] = metric.term(std::max({low - p[axis], p[axis] - (low + 1), 0.0}));
    }
  }
  Nearest nearest;
  for (const NearbyCube& cube : kNearby) {
    if (metric.is_euclidean() && cube.least_square > nearest.distances[2]) break;
    const auto [i, j, k] = cube.place;
    if (gaps[0][i] + gaps[1][j] + gaps[2][k] > nearest.distances[2]) continue;
    const Vec3 point = point_in(neighbour(home, steps[0][i], steps[1][j], steps[2][k]));
    nearest.add(metric.comparable(p - point), point);
  }
  return nearest;
}

double cells_at(const PatternPoint& at) noexcept { return *random_numbers(cube_of(at.point + Vec3(kBelowCube))); }

struct Crackle {
  Vec3 form{-1, 1, 0};  ///< weights of the distances to the nearest three points
  double metric = 2;
  double offset = 0;
  bool is_solid = false;
};
constexpr scene::OperandField kCrackle[] = {
    scene::modifier<&Crackle::form>("form"), scene::modifier<&Crackle::metric>("metric"),
    scene::modifier<&Crackle::offset>("offset"),
    scene::modifier<&Crackle::is_solid>("solid").dumped_with<&Crackle::is_solid>()};

/// One random feature point in every unit cube; form · (distances to the nearest three), which `offset` keeps apart,
/// cut to [0, 1]; or the noise at the nearest.
double crackle_at(const PatternPoint& at) noexcept {
  const Crackle& operands = at.operands<Crackle>();
  const Metric metric(operands.metric, operands.offset);
  const Nearest nearest = find_nearest(at.point, metric);
  if (operands.is_solid) return values::noise(nearest.point, at.noise_generator());
  const double sum = operands.form.x * metric.distance(nearest.distances[0]) +
                     operands.form.y * metric.distance(nearest.distances[1]) +
                     operands.form.z * metric.distance(nearest.distances[2]);
  return std::clamp(sum, 0.0, 1.0);
}

/// The size of facets in space (coords) or of the normal. Exactly one of the two is above 0; the last word in the scene
/// decides.
struct Facets {
  double coords = 0;
  double size = 0;
};
void read_coords(scene::OperandReader& reader, Facets& facets) noexcept {
  facets = {.coords = reader.number("`coords`")};
}
void read_size(scene::OperandReader& reader, Facets& facets) noexcept { facets = {.size = reader.number("`size`")}; }
constexpr scene::OperandField kFacets[] = {
    scene::modifier<&Facets::coords>("coords").read_by<read_coords>().dumped_with<&Facets::coords>(),
    scene::modifier<&Facets::size>("size").read_by<read_size>().dumped_with<&Facets::size>()};

/// Flat facets, like those of hammered metal: all normals near a feature point become that point's direction; or, with
/// `coords`, all normals in its cell are turned alike.
Vec3 bend_by_facets(const PatternPoint& at, const Vec3& normal, double /*size*/) noexcept {
  const Facets& facets = at.operands<Facets>();
  const Metric metric(2, 0);
  constexpr double kDefaultSize = 0.1;
  if (!(facets.coords > 0)) {
    const double size = facets.size > 0 ? facets.size : kDefaultSize;
    return find_nearest(normal / size, metric).point;
  }
  const Vec3 push = values::vector_noise(find_nearest(at.point / kDefaultSize, metric).point);
  return normal + (push - normal * push.dot(normal)) * facets.coords;
}

}  // namespace

constinit const PatternInfo pattern_kinds::cells{.value = cells_at};
constinit const PatternInfo pattern_kinds::crackle{.operands = operands_of<Crackle, kCrackle>, .value = crackle_at};
constinit const PatternInfo pattern_kinds::facets{
    .hosts = kNormalsOnly, .operands = operands_of<Facets, kFacets>, .bend = bend_by_facets};

}  // namespace isl::render
