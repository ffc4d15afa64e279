#include "renderer/fields/component_table.h"

#include "renderer/fields/convolutions/curve_field.h"
#include "renderer/fields/record_skeleton.h"

#include "base/check.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>

namespace isl::render {
namespace {

/// The factor by which a similarity scales every length; nothing for any other map. Rotations, mirrors and uniform
/// scalings map spheres to spheres, so they can be baked into a component. The tolerance on the rows' lengths and
/// angles is for rounding only: 16 units in the last place cover the products of a dozen transforms.
std::optional<double> similarity_factor(const scene::Matrix& m) {
  const Vec3 rows[3] = {{m[0][0], m[0][1], m[0][2]}, {m[1][0], m[1][1], m[1][2]}, {m[2][0], m[2][1], m[2][2]}};
  const double square = rows[0].length2();
  constexpr double kSlack = 16 * 0x1p-52;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(rows[i].length2() - square) > kSlack * square) return std::nullopt;
    if (std::abs(rows[i].dot(rows[(i + 1) % 3])) > kSlack * square) return std::nullopt;
  }
  return std::sqrt(square);
}

/// True for a convolved segment without a length, whose integral is 0.
bool is_void(const scene::Database& database, const scene::Component& c) {
  const scene::FieldMode mode = database.kernels[scene::index(c.kernel)].mode;
  return mode == scene::FieldMode::convolution && has(c.skeleton, scene::kEndB) && has_no_length(c);
}

/// A component in blob space, with the maps that its record takes baked in, before sorting.
struct Prepared {
  scene::Component component;
  Vec3 third_corner;  ///< by value: the index in blob.corners depends on the order in the scene
  std::uint32_t source;
  std::uint64_t morton = 0;

  [[nodiscard]] bool is_mapped() const { return component.transform != scene::kIdentity; }
};

/// The last key of the canonical order. Two components of one group with equal keys have the same field and texture.
auto parameters(const Prepared& p) {
  const scene::Component& c = p.component;
  return std::tuple(c.a.x, c.a.y, c.a.z, c.b.x, c.b.y, c.b.z, c.radius_a, c.radius_b, c.strength, p.third_corner.x,
                    p.third_corner.y, p.third_corner.z, scene::index(c.texture));
}

Prepared prepare(const scene::Database& database, const scene::Blob& blob, std::uint32_t source) {
  Prepared p{simplified(blob.components[source]), Vec3(0), source};
  scene::Component& c = p.component;
  if (has(c.skeleton, scene::kCorner)) p.third_corner = blob.corners[c.corner];
  if (!p.is_mapped()) return p;
  const scene::Transform& transform = database.transforms[scene::index(c.transform)];
  if (scene::is_endless(c.skeleton)) {
    const Vec3 normal = transform.normal(c.b);
    const double length = normal.length();
    c.a = transform.point(c.a);
    c.b = normal / length;
    c.radius_a /= length;
    c.transform = scene::kIdentity;
    return p;
  }
  if (!has(c.skeleton, scene::kTakesSimilarities)) return p;
  if (const auto factor = similarity_factor(transform.matrix)) {
    c.a = transform.point(c.a);
    c.b = transform.point(c.b);
    c.radius_a *= *factor;
    c.radius_b *= *factor;
    c.transform = scene::kIdentity;
  }
  return p;
}

std::uint64_t spread(std::uint64_t x) {
  x &= 0x1FFFFF;
  x = (x | x << 32) & 0x1F00000000FFFFull;
  x = (x | x << 16) & 0x1F0000FF0000FFull;
  x = (x | x << 8) & 0x100F00F00F00F00Full;
  x = (x | x << 4) & 0x10C30C30C30C30C3ull;
  return (x | x << 2) & 0x1249249249249249ull;
}

void set_morton_codes(std::vector<Prepared>& prepared) {
  Box box;
  for (const Prepared& p : prepared) box.extendBy(p.component.a);
  const Vec3 size = box.size();
  const double extent = std::max({size.x, size.y, size.z});
  const double cells = extent > 0 ? 0x1.FFFFFp20 / extent : 0;
  for (Prepared& p : prepared) {
    const Vec3 cell = (p.component.a - box.min) * cells;
    p.morton = spread(static_cast<std::uint64_t>(cell.x)) | spread(static_cast<std::uint64_t>(cell.y)) << 1 |
               spread(static_cast<std::uint64_t>(cell.z)) << 2;
  }
}

/// The axis-aligned box around the image of a box.
Box image(const Box& box, const scene::Matrix& m) {
  const Vec3 half = box.size() * 0.5;
  const Vec3 centre = scene::Transform::transformed(box.center(), m);
  Vec3 extent;
  for (int axis = 0; axis < 3; ++axis) {
    extent[axis] = std::abs(m[0][axis]) * half.x + std::abs(m[1][axis]) * half.y + std::abs(m[2][axis]) * half.z;
  }
  return {centre - extent, centre + extent};
}

template <class Shape>
std::vector<Shape>& column(ComponentTable& table) {
  return std::get<std::vector<Shape>>(table.shapes);
}

}  // namespace

const FieldGroup& ComponentTable::group_of(std::uint32_t component) const {
  const auto after = std::upper_bound(groups.begin(), groups.end(), component,
                                      [](std::uint32_t c, const FieldGroup& g) { return c < g.end; });
  ISL_DCHECK(after != groups.end(), "{}", component);
  return *after;
}

std::size_t ComponentTable::bytes() const {
  const auto of_rows = [](const auto&... columns) { return ((columns.capacity() * sizeof(columns[0])) + ...); };
  return of_rows(x, y, z, scale, amplitude, texture, source, branch, maps) + std::apply(of_rows, shapes) +
         supports.bytes();
}

namespace {

constexpr std::size_t kLargestShape = [] {
  std::size_t largest = 0;
#define ISL_SKELETON(word, Type, record) largest = std::max(largest, sizeof(Type));
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
  return largest;
}();

}  // namespace

std::size_t most_table_bytes(const scene::Blob& blob) {
  constexpr std::size_t kRow =
      5 * sizeof(double) + sizeof(SupportBall) + sizeof(scene::TextureId) + 2 * sizeof(std::uint32_t);
  std::size_t shapes = 0, maps = 0;
  for (const scene::Component& c : blob.components) {
    shapes += c.skeleton != scene::Skeleton::point;
    maps += c.transform != scene::kIdentity;
  }
  // Shapes and maps grow to twice their size, and are held twice while they move.
  return blob.components.size() * (sizeof(Prepared) + kRow) +
         3 * (shapes * kLargestShape + maps * sizeof(scene::Transform));
}

ComponentTable compile_components(const scene::Database& database, const scene::Blob& blob, bool unblended) {
  const bool is_unblended = unblended || blob.is_unblended;
  std::vector<Prepared> prepared;
  prepared.reserve(blob.components.size());
  for (std::uint32_t i = 0; i < blob.components.size(); ++i) {
    const double strength = blob.components[i].strength;
    if (is_void(database, blob.components[i])) continue;
    if (is_unblended ? strength > 0 : strength != 0) prepared.push_back(prepare(database, blob, i));
  }
  set_morton_codes(prepared);
  const auto group_of = [](const Prepared& p) {
    return std::tuple(p.is_mapped(), p.component.skeleton, p.component.kernel);
  };
  std::sort(prepared.begin(), prepared.end(), [&](const Prepared& p, const Prepared& q) {
    if (group_of(p) != group_of(q)) return group_of(p) < group_of(q);
    if (p.morton != q.morton) return p.morton < q.morton;
    return parameters(p) < parameters(q);
  });

  ComponentTable table;
  table.database = &database;
  table.blob = &blob;
  table.threshold = blob.threshold;
  table.is_unblended = is_unblended;
  if (!is_unblended) table.tree = BranchTree({blob.branches.begin(), blob.branches.end()});
  const auto n = static_cast<std::uint32_t>(prepared.size());
  for (auto* column : {&table.x, &table.y, &table.z, &table.scale, &table.amplitude}) column->reserve(n);
  table.texture.reserve(n);
  table.source.reserve(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Prepared& p = prepared[i];
    const scene::Component& c = p.component;
    if (i == 0 || group_of(prepared[i - 1]) != group_of(p)) {
      const KernelConstants kernel = kernel_constants(database.kernels[static_cast<std::size_t>(c.kernel)]);
      const std::uint32_t first_shape = with_skeleton_type(c.skeleton, [&](auto type) {
        return static_cast<std::uint32_t>(column<typename decltype(type)::type>(table).size());
      });
      const auto first_map = static_cast<std::uint32_t>(table.maps.size());
      const std::optional<double> surface =
          kernel.is_convolved ? std::nullopt : passing_argument(kernel, c.strength * kernel.amplitude, blob.threshold);
      table.groups.push_back({p.is_mapped(), c.skeleton, kernel, i, i, first_shape, first_map, surface.value_or(0)});
    }
    FieldGroup& group = table.groups.back();
    group.end = i + 1;
    const bool is_point = c.skeleton == scene::Skeleton::point;
    Vec3 middle = c.a;
    if (!is_point) {
      with_skeleton_of(blob, c, [&](const auto& shape) {
        column<std::decay_t<decltype(shape)>>(table).push_back(shape);
        middle = shape.middle();
      });
    }
    if (p.is_mapped()) table.maps.push_back(database.transforms[scene::index(c.transform)]);
    table.x.push_back(middle.x);
    table.y.push_back(middle.y);
    table.z.push_back(middle.z);
    table.scale.push_back(is_point ? group.kernel.scale / (c.radius_a * c.radius_a) : group.kernel.scale);
    table.amplitude.push_back(c.strength * group.kernel.amplitude);
    table.texture.push_back(c.texture);
    table.has_one_texture &= c.texture == table.texture.front();
    table.source.push_back(p.source);
    if (table.tree.size() > 0) table.branch.push_back(blob.branch_of[p.source]);
    if (is_point && !p.is_mapped() && table.plain_points == i) ++table.plain_points;
  }
  table.supports = support_balls(table);
  return table;
}

namespace {

template <class Shape>
FieldRange range_of_distance(const ComponentTable& table, const FieldGroup& group, std::uint32_t component,
                             const Box& box) {
  const QRange q = table.shape<Shape>(group, component).q_over(box);
  const double scale = ComponentTable::v_scale(group);
  if (!(scale * q.low < group.kernel.support)) return {0, 0};
  const double near = table.amplitude[component] * kernel_profile(group.kernel, scale * q.low);
  const double far = table.amplitude[component] * kernel_profile(group.kernel, scale * q.high);
  return {std::min(near, far), std::max(near, far)};
}

/// The range over a box for components that are mapped or convolved.
template <class Shape>
[[gnu::noinline]] FieldRange other_range(const ComponentTable& table, const FieldGroup& group, std::uint32_t component,
                                         const Box& blob_box) {
  const Box box = group.is_mapped ? image(blob_box, table.blob_from_component(group, component).inverse) : blob_box;
  if (!group.kernel.is_convolved) return range_of_distance<Shape>(table, group, component, box);
  const CurveRange range = curve_range(group.kernel, table.shape<Shape>(group, component), box);
  const double amplitude = table.amplitude[component];
  return {std::min(amplitude * range.low, amplitude * range.high),
          std::max(amplitude * range.low, amplitude * range.high)};
}

/// The range over a box. A grid computes it for many pairs of component and cell, which takes most of the time of
/// building it. So each skeleton has a function of its own, into which the code that skeletons share is inlined,
/// however many skeletons there are.
template <class Shape>
[[gnu::noinline, gnu::flatten]] FieldRange range_of(const ComponentTable& table, const FieldGroup& group,
                                                    std::uint32_t component, const Box& box) {
  if (group.is_mapped || group.kernel.is_convolved) return other_range<Shape>(table, group, component, box);
  return range_of_distance<Shape>(table, group, component, box);
}

}  // namespace

FieldRange field_range(const ComponentTable& table, const FieldGroup& group, std::uint32_t component, const Box& box) {
  return with_skeleton_type(
      group.skeleton, [&](auto type) { return range_of<typename decltype(type)::type>(table, group, component, box); });
}

double support_radius(const ComponentTable& table, const FieldGroup& group, std::uint32_t component) {
  const auto thickest = [](const auto& skeleton) { return skeleton.thickest(); };
  return table.with_skeleton(group, component, thickest) * ComponentTable::support_root(group);
}

Box support_bounds(const ComponentTable& table, const FieldGroup& group, std::uint32_t component) {
  const double root_q = ComponentTable::support_root(group);
  Box box;
  table.with_skeleton(group, component, [&](const auto& skeleton) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        Vec3 n(0);
        n[axis] = sign;
        double most = -std::numeric_limits<double>::infinity();
        for (const Reach& end : skeleton.reach(n)) most = std::max(most, end.coordinate + end.radius * root_q);
        (sign < 0 ? box.min : box.max)[axis] = sign * most;
      }
    }
  });
  return group.is_mapped ? image(box, table.blob_from_component(group, component).matrix) : box;
}

double field_at(const scene::Database& database, const scene::Blob& blob, const scene::Component& component,
                const KernelConstants& kernel, const Vec3& point) {
  const bool is_moved = component.transform != scene::kIdentity;
  const Vec3 p = is_moved ? database.transforms[scene::index(component.transform)].inverse_point(point) : point;
  if (kernel.is_convolved) {
    if (is_void(database, component)) return 0;
    const auto value = [&](const auto& skeleton) { return curve_sample(kernel, skeleton, p).value; };
    return component.strength * kernel.amplitude * with_skeleton_of(blob, component, value);
  }
  const auto q = [&](const auto& skeleton) { return skeleton.nearest(p).q(); };
  return component.strength * kernel_value(kernel, with_skeleton_of(blob, component, q));
}

double most_at(const scene::Database& database, const scene::Blob& blob, const scene::Component& component,
               const KernelConstants& kernel, double q) {
  if (!kernel.is_convolved) return std::abs(component.strength) * kernel_value(kernel, q);
  if (is_void(database, component)) return 0;
  const auto most = [&](const auto& skeleton) { return curve_most(kernel, skeleton, q); };
  return std::abs(component.strength) * kernel.amplitude * with_skeleton_of(blob, component, most);
}

double peak_of(const scene::Database& database, const scene::Blob& blob, const scene::Component& component,
               const KernelConstants& kernel) {
  if (is_void(database, component)) return 0;
  const auto peak = [&](const auto& skeleton) { return curve_peak(kernel, skeleton); };
  return std::abs(component.strength) * kernel.amplitude * with_skeleton_of(blob, component, peak);
}

void set_reaches(const scene::Database& database, const scene::Blob& blob, const scene::Component& component,
                 std::span<const Vec3> directions, std::span<std::array<Reach, 2>> reaches) {
  const scene::Transform* const place =
      component.transform != scene::kIdentity ? &database.transforms[scene::index(component.transform)] : nullptr;
  with_skeleton_of(blob, component, [&](const auto& skeleton) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Vec3& n = directions[i];
      if (!place) {
        reaches[i] = skeleton.reach(n);
        continue;
      }
      const scene::Matrix& m = place->matrix;
      // n·(Mp + s) = (Mᵀn)·p + n·s; one radius measures |Mᵀn| along n.
      const Vec3 own_n(n.dot({m[0][0], m[0][1], m[0][2]}), n.dot({m[1][0], m[1][1], m[1][2]}),
                       n.dot({m[2][0], m[2][1], m[2][2]}));
      reaches[i] = skeleton.reach(own_n);
      for (Reach& r : reaches[i]) {
        r.coordinate += n.dot({m[3][0], m[3][1], m[3][2]});
        r.radius *= own_n.length();
      }
    }
  });
}

}  // namespace isl::render
