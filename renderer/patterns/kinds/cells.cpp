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
Vec3 point_in(const RandomCubes& cubes, const Cube& cube) noexcept {
  const double* const random = cubes.of(cube);
  return {cube.x + random[0], cube.y + random[1], cube.z + random[2]};
}

/// A coordinate's cube, as often as so many of them repeat; 0: they do not.
int wrapped(int cube, int repeat) noexcept {
  if (repeat == 0) return cube;
  const int rest = cube % repeat;
  return rest < 0 ? rest + repeat : rest;
}

/// The same where the cubes repeat along the axes.
Vec3 repeated_point_in(const RandomCubes& cubes, const Cube& cube, const int (&repeat)[3]) noexcept {
  const double* const random =
      cubes.of({wrapped(cube.x, repeat[0]), wrapped(cube.y, repeat[1]), wrapped(cube.z, repeat[2])});
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

  /// False if it is none of the nearest three.
  bool add(double distance, const Vec3& p) noexcept {
    if (distance >= distances[2]) return false;
    if (distance < distances[0]) point = p;
    distances[2] = distance;
    if (distances[2] < distances[1]) std::swap(distances[1], distances[2]);
    if (distances[1] < distances[0]) std::swap(distances[0], distances[1]);
    return true;
  }
};

/// The cubes that can hold one of the nearest points: a block of 5³ without its corners. Along each axis they are, in
/// this order, the point's own, the nearer neighbour, the other one, and the two behind these.
constexpr int kCubes = 5;
constexpr int kStepsAway[kCubes] = {0, 1, 1, 2, 2};
constexpr int kFarthest = 4;  ///< sum of the steps along the axes
/// Any other cube is farther away than this: one that lies two steps away along two axes and one step along the third
/// is at least √2 away.
constexpr double kLeastBeyond = 1.414;
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

/// Calls visit(point) for feature points around p, the nearest cubes first: for all within `reach(nearest)`, as the
/// metric compares distances, and maybe others. Returns the nearest three. A cube's feature point is feature(cubes,
/// cube).
template <class Reach, class Visit, class Feature = decltype(&point_in)>
Nearest search(const Vec3& p, const Metric& metric, const Reach& reach, const Visit& visit,
               const Feature& feature = point_in) noexcept {
  const RandomCubes& cubes = random_cubes();
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
  double far = reach(nearest);
  for (const NearbyCube& cube : kNearby) {
    if (metric.is_euclidean() && cube.least_square > far) break;
    const auto [i, j, k] = cube.place;
    if (gaps[0][i] + gaps[1][j] + gaps[2][k] > far) continue;
    const Vec3 point = feature(cubes, neighbour(home, steps[0][i], steps[1][j], steps[2][k]));
    if (nearest.add(metric.comparable(p - point), point)) far = reach(nearest);
    visit(point);
  }
  return nearest;
}

Nearest find_nearest(const Vec3& p, const Metric& metric) noexcept {
  return search(
      p, metric, [](const Nearest& nearest) { return nearest.distances[2]; }, [](const Vec3& /*point*/) {});
}

double cells_at(const PatternPoint& at) noexcept { return *random_cubes().of(cube_of(at.point + Vec3(kBelowCube))); }

struct Crackle {
  Vec3 form{-1, 1, 0};  ///< weights of the distances to the nearest three points
  double metric = 2;
  double offset = 0;
  bool is_solid = false;
  Vec3 repeat{0};  ///< numbers of cubes after which the pattern repeats along each axis; 0: it does not
  bool repeats = false;
};

void read_repeat(scene::OperandReader& reader, Crackle& crackle) noexcept {
  constexpr double kMost = 1e9;  // numbers of cubes are integers
  crackle.repeat = reader.vector("`repeat`");
  for (int axis = 0; axis < 3; ++axis) {
    const double count = crackle.repeat[axis];
    if (!(count >= 0 && count <= kMost && count == std::trunc(count))) {
      reader.fail("`repeat` of `crackle` takes a whole number of cells for each axis, from 0, which repeats none");
      crackle.repeat = Vec3(0);
      break;
    }
  }
  crackle.repeats = crackle.repeat != Vec3(0);
}

constexpr scene::OperandField kCrackle[] = {
    scene::modifier<&Crackle::form>("form"), scene::modifier<&Crackle::metric>("metric"),
    scene::modifier<&Crackle::offset>("offset"),
    scene::modifier<&Crackle::is_solid>("solid").dumped_with<&Crackle::is_solid>(),
    scene::modifier<&Crackle::repeat>("repeat").read_by<read_repeat>().dumped_with<&Crackle::repeats>()};

/// The value where these points are the nearest: form · (their distances), cut to [0, 1]; or the noise at the first.
double crackle_of(const PatternPoint& at, const Metric& metric, const Nearest& nearest) noexcept {
  const Crackle& operands = at.operands<Crackle>();
  if (operands.is_solid) return values::noise(nearest.point, at.noise_generator());
  const double sum = operands.form.x * metric.distance(nearest.distances[0]) +
                     operands.form.y * metric.distance(nearest.distances[1]) +
                     operands.form.z * metric.distance(nearest.distances[2]);
  return std::clamp(sum, 0.0, 1.0);
}

Metric metric_of(const PatternPoint& at) noexcept {
  const Crackle& operands = at.operands<Crackle>();
  return {operands.metric, operands.offset};
}

/// Every period has the same feature points, at whole periods from those of the first one.
[[gnu::noinline]] double repeated_crackle_at(const PatternPoint& at, const Vec3& p) noexcept {
  const Crackle& operands = at.operands<Crackle>();
  const int repeat[3] = {static_cast<int>(operands.repeat.x), static_cast<int>(operands.repeat.y),
                         static_cast<int>(operands.repeat.z)};
  const Metric metric = metric_of(at);
  Nearest nearest = search(
      p, metric, [](const Nearest& found) { return found.distances[2]; }, [](const Vec3& /*point*/) {},
      [&](const RandomCubes& cubes, const Cube& cube) { return repeated_point_in(cubes, cube, repeat); });
  // `solid` has the noise at the point of the first period.
  const Cube cube = cube_of(nearest.point);
  nearest.point += Vec3(wrapped(cube.x, repeat[0]) - cube.x, wrapped(cube.y, repeat[1]) - cube.y,
                        wrapped(cube.z, repeat[2]) - cube.z);
  return crackle_of(at, metric, nearest);
}

/// One random feature point in every unit cube, and the nearest three of them.
double crackle_at(const PatternPoint& at) noexcept {
  if (at.operands<Crackle>().repeats) [[unlikely]]
    return repeated_crackle_at(at, at.point);
  const Metric metric = metric_of(at);
  return crackle_of(at, metric, find_nearest(at.point, metric));
}

/// Points within r of p have their nearest three no farther from p than p's own third is, plus 2r: from p to the point
/// and back. One search finds all that are so near, as long as none of them can lie in a cube that the search of one of
/// the points would leave out: such cubes are kLeastBeyond away from that point, and from p at most r less.
void crackle_near(const PatternPoint& at, std::span<const Vec3> points, std::span<double> values) noexcept {
  if (at.operands<Crackle>().repeats) [[unlikely]] {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = repeated_crackle_at(at, points[i]);
    return;
  }
  const Metric metric = metric_of(at);
  double square = 0;
  for (const Vec3& point : points) square = std::max(square, (point - at.point).length2());
  const double r = std::sqrt(square), offset = metric.comparable(Vec3(0));
  // The distances are those of three dimensions, since the fourth is the same for all.
  const auto far_of = [&](const Nearest& nearest) {
    return std::sqrt(std::max(nearest.distances[2] - offset, 0.0)) + 2 * r;
  };
  constexpr double kMargin = 1 + 0x1p-40;  // far more than the rounding of coordinates that distances are found from
  const auto reach = [&](const Nearest& nearest) {
    const double far = far_of(nearest);
    return far * far * kMargin + offset;
  };
  std::array<Vec3, kNearbyCubes> found;
  std::size_t count = 0;
  if (metric.is_euclidean() && r < kLeastBeyond) {
    const Nearest nearest = search(at.point, metric, reach, [&](const Vec3& point) { found[count++] = point; });
    const double most = reach(nearest);
    if (far_of(nearest) + r < kLeastBeyond) {
      const auto end = std::remove_if(found.begin(), found.begin() + count,
                                      [&](const Vec3& point) { return metric.comparable(at.point - point) > most; });
      for (std::size_t i = 0; i < points.size(); ++i) {
        Nearest own;
        std::for_each(found.begin(), end, [&](const Vec3& f) { own.add(metric.comparable(points[i] - f), f); });
        values[i] = crackle_of(at, metric, own);
      }
      return;
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) values[i] = crackle_of(at, metric, find_nearest(points[i], metric));
}

/// `size` is that of facets: in space if `coords` is above 0, which is how far they turn, else of the normal.
struct Facets {
  double coords = 0;
  double size = 0.1;
};
void read_coords(scene::OperandReader& reader, Facets& facets) noexcept { facets.coords = reader.number("`coords`"); }
void read_size(scene::OperandReader& reader, Facets& facets) noexcept { facets.size = reader.number("`size`"); }
constexpr scene::OperandField kFacets[] = {
    scene::modifier<&Facets::coords>("coords").read_by<read_coords>().dumped_with<&Facets::coords>(),
    scene::modifier<&Facets::size>("size").read_by<read_size>().dumped_with<&Facets::size>()};

/// Flat facets, like those of hammered metal: all normals near a feature point become that point's direction; or, with
/// `coords`, all normals in its cell are turned alike.
Vec3 bend_by_facets(const PatternPoint& at, const Vec3& normal, double /*size*/) noexcept {
  const Facets& facets = at.operands<Facets>();
  const Metric metric(2, 0);
  constexpr double kLeastSize = 1e-6;  // as in POV-Ray
  const double size = std::max(facets.size, kLeastSize);
  if (!(facets.coords > 0)) return find_nearest(normal / size, metric).point;
  const Vec3 push = values::vector_noise(find_nearest(at.point / size, metric).point);
  return normal + (push - normal * push.dot(normal)) * facets.coords;
}

}  // namespace

constinit const PatternInfo pattern_kinds::cells{.value = cells_at};
constinit const PatternInfo pattern_kinds::crackle{
    .operands = operands_of<Crackle, kCrackle>, .value = crackle_at, .values_near = crackle_near};
constinit const PatternInfo pattern_kinds::facets{
    .hosts = kNormalsOnly, .operands = operands_of<Facets, kFacets>, .bend = bend_by_facets};

}  // namespace isl::render
