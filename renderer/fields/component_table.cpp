#include "renderer/fields/component_table.h"

#include "base/check.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <tuple>

namespace isl::render {
namespace {

/// The factor by which a map stretches every length, if it does so evenly: rotations, mirrors and uniform scalings keep spheres
/// spheres and can be baked in. The columns' lengths and angles may miss that by rounding only: 16 units in the last place
/// cover the products of a dozen transforms.
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

/// A component in blob space (similarities baked in), before sorting.
struct Prepared {
  FieldForm form;
  scene::KernelId kernel;
  Vec3 a, b;
  double radius_a, radius_b, strength;
  scene::TransformId transform;
  scene::TextureId texture;
  std::uint32_t source;
  std::uint64_t morton = 0;
};

/// Geometry apart, what makes two components the same: the last word in the canonical order.
auto parameters(const Prepared& p) {
  return std::tuple(p.a.x, p.a.y, p.a.z, p.b.x, p.b.y, p.b.z, p.radius_a, p.radius_b, p.strength, scene::index(p.texture));
}

Prepared prepare(const scene::Database& database, const scene::Component& c, std::uint32_t source) {
  Prepared p{FieldForm::point, c.kernel, c.a, c.b, c.radius_a, c.radius_b, c.strength, c.transform, c.texture, source};
  const bool limb = c.skeleton != scene::Skeleton::point && c.a != c.b;
  if (c.skeleton != scene::Skeleton::cone) p.radius_b = p.radius_a;
  if (!limb) {
    p.b = p.a;
    p.radius_a = std::max(p.radius_a, p.radius_b);
  }
  p.form = limb ? FieldForm::limb : FieldForm::point;
  if (c.transform == scene::kIdentity) return p;
  const scene::Transform& transform = database.transforms[scene::index(c.transform)];
  if (const auto factor = similarity_factor(transform.matrix)) {
    p.a = transform.point(p.a);
    p.b = transform.point(p.b);
    p.radius_a *= *factor;
    p.radius_b *= *factor;
    p.transform = scene::kIdentity;
  } else {
    p.form = limb ? FieldForm::affine_limb : FieldForm::affine_point;
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
  for (const Prepared& p : prepared) box.extendBy(p.a);
  const Vec3 size = box.size();
  const double extent = std::max({size.x, size.y, size.z});
  const double cells = extent > 0 ? 0x1.FFFFFp20 / extent : 0;
  for (Prepared& p : prepared) {
    const Vec3 cell = (p.a - box.min) * cells;
    p.morton = spread(static_cast<std::uint64_t>(cell.x)) | spread(static_cast<std::uint64_t>(cell.y)) << 1 |
               spread(static_cast<std::uint64_t>(cell.z)) << 2;
  }
}

Limb make_limb(const Prepared& p) {
  const Vec3 ab = p.b - p.a;
  const double length = ab.length();
  return {p.a, ab / length, length, p.radius_a, (p.radius_b - p.radius_a) / length};
}

struct Range {
  double low, high;
};

/// Squared distance from a point to a box: least and greatest.
Range squared_distance(const Vec3& p, const Box& box) {
  Range range{0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const double below = box.min[axis] - p[axis], above = p[axis] - box.max[axis];
    const double nearest = std::max({below, above, 0.0});
    const double farthest = std::max(-below, -above);
    range.low += nearest * nearest;
    range.high += farthest * farthest;
  }
  return range;
}

/// q of a limb over a box, through the rectangle in (x, ρ) that holds the box.
Range limb_q(const Limb& limb, const Box& box) {
  const Vec3 half = box.size() * 0.5;
  const Vec3 centre = box.center() - limb.a;
  const double x = centre.dot(limb.axis);
  const double half_x = std::abs(limb.axis.x) * half.x + std::abs(limb.axis.y) * half.y + std::abs(limb.axis.z) * half.z;
  const double rho = (centre - limb.axis * x).length();
  double least_axial2 = half_x * half_x;
  for (const Vec3& diagonal : {Vec3(-half.x, half.y, half.z), Vec3(half.x, -half.y, half.z), Vec3(half.x, half.y, -half.z)}) {
    const double axial = diagonal.dot(limb.axis);
    least_axial2 = std::min(least_axial2, axial * axial);
  }
  const double half_rho = std::sqrt(std::max(half.length2() - least_axial2, 0.0));
  const double rho_low = std::max(rho - half_rho, 0.0), rho_high = rho + half_rho;
  const double nearest_x = std::clamp(limb.thick_end(), x - half_x, x + half_x);
  return {limb.q(nearest_x, rho_low * rho_low),
          std::max(limb.q(x - half_x, rho_high * rho_high), limb.q(x + half_x, rho_high * rho_high))};
}

/// An axis-parallel box around the image of a box.
Box image(const Box& box, const scene::Matrix& m) {
  const Vec3 half = box.size() * 0.5;
  const Vec3 centre = scene::Transform::transformed(box.center(), m);
  Vec3 extent;
  for (int axis = 0; axis < 3; ++axis) {
    extent[axis] = std::abs(m[0][axis]) * half.x + std::abs(m[1][axis]) * half.y + std::abs(m[2][axis]) * half.z;
  }
  return {centre - extent, centre + extent};
}

bool is_affine(FieldForm form) { return form == FieldForm::affine_point || form == FieldForm::affine_limb; }
bool is_limb(FieldForm form) { return form == FieldForm::limb || form == FieldForm::affine_limb; }

}  // namespace

const FieldGroup& ComponentTable::group_of(std::uint32_t component) const {
  const auto after = std::upper_bound(groups.begin(), groups.end(), component,
                                      [](std::uint32_t c, const FieldGroup& g) { return c < g.end; });
  ISL_DCHECK(after != groups.end(), "{}", component);
  return *after;
}

std::size_t ComponentTable::bytes() const {
  return (x.capacity() + y.capacity() + z.capacity() + scale.capacity() + amplitude.capacity()) * sizeof(double) +
         texture.capacity() * sizeof(scene::TextureId) + source.capacity() * sizeof(std::uint32_t) +
         limbs.capacity() * sizeof(Limb) + blob_from_component.capacity() * sizeof(scene::Transform);
}

ComponentTable compile_components(const scene::Database& database, const scene::Blob& blob) {
  std::vector<Prepared> prepared;
  prepared.reserve(blob.components.size());
  for (std::uint32_t i = 0; i < blob.components.size(); ++i) {
    if (blob.components[i].strength != 0) prepared.push_back(prepare(database, blob.components[i], i));
  }
  set_morton_codes(prepared);
  std::sort(prepared.begin(), prepared.end(), [](const Prepared& p, const Prepared& q) {
    if (p.form != q.form) return p.form < q.form;
    if (p.kernel != q.kernel) return p.kernel < q.kernel;
    if (p.morton != q.morton) return p.morton < q.morton;
    return parameters(p) < parameters(q);
  });

  ComponentTable table;
  table.threshold = blob.threshold;
  const auto n = static_cast<std::uint32_t>(prepared.size());
  table.first_limb = table.first_affine = n;
  for (auto* column : {&table.x, &table.y, &table.z, &table.scale, &table.amplitude}) column->reserve(n);
  table.texture.reserve(n);
  table.source.reserve(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Prepared& p = prepared[i];
    const bool same = i > 0 && prepared[i - 1].form == p.form && prepared[i - 1].kernel == p.kernel;
    if (!same) {
      table.groups.push_back({p.form, kernel_constants(database.kernels[static_cast<std::size_t>(p.kernel)]), i, i});
    }
    FieldGroup& group = table.groups.back();
    group.end = i + 1;
    // Order of forms: point, limb, affine_point, affine_limb. Rows of limbs and maps run to the end from their first use.
    if (is_limb(p.form) || is_affine(p.form)) {
      table.first_limb = std::min(table.first_limb, i);
      table.limbs.push_back(is_limb(p.form) ? make_limb(p) : Limb{p.a, Vec3(0, 0, 1), 0, p.radius_a, 0});
    }
    if (is_affine(p.form)) {
      table.first_affine = std::min(table.first_affine, i);
      table.blob_from_component.push_back(database.transforms[scene::index(p.transform)]);
    }
    table.x.push_back(p.a.x);
    table.y.push_back(p.a.y);
    table.z.push_back(p.a.z);
    table.scale.push_back(is_limb(p.form) ? group.kernel.scale : group.kernel.scale / (p.radius_a * p.radius_a));
    table.amplitude.push_back(p.strength * group.kernel.amplitude);
    table.texture.push_back(p.texture);
    table.source.push_back(p.source);
  }
  return table;
}

FieldRange field_range(const ComponentTable& table, const FieldGroup& group, std::uint32_t component, const Box& blob_box) {
  const Box box = is_affine(group.form)
                      ? image(blob_box, table.blob_from_component[component - table.first_affine].inverse)
                      : blob_box;
  const Range argument = is_limb(group.form)
                             ? limb_q(table.limbs[component - table.first_limb], box)
                             : squared_distance({table.x[component], table.y[component], table.z[component]}, box);
  if (!(table.scale[component] * argument.low < group.kernel.support)) return {0, 0};
  const double near = table.amplitude[component] * kernel_profile(group.kernel, table.scale[component] * argument.low);
  const double far = table.amplitude[component] * kernel_profile(group.kernel, table.scale[component] * argument.high);
  return {std::min(near, far), std::max(near, far)};
}

double support_radius(const ComponentTable& table, const FieldGroup& group, std::uint32_t component) {
  if (!is_limb(group.form)) return std::sqrt(group.kernel.support / table.scale[component]);
  const Limb& limb = table.limbs[component - table.first_limb];
  return std::max(limb.radius, limb.radius_at(limb.length)) * std::sqrt(group.kernel.support_q());
}

Box support_bounds(const ComponentTable& table, const FieldGroup& group, std::uint32_t component) {
  const Vec3 a(table.x[component], table.y[component], table.z[component]);
  Box box;
  if (is_limb(group.form)) {
    const Limb& limb = table.limbs[component - table.first_limb];
    const double reach = std::sqrt(group.kernel.support_q());
    const Vec3 at_a(limb.radius * reach), at_b(limb.radius_at(limb.length) * reach);
    const Vec3 b = a + limb.axis * limb.length;
    box.extendBy(Box(a - at_a, a + at_a));
    box.extendBy(Box(b - at_b, b + at_b));
  } else {
    const Vec3 reach(support_radius(table, group, component));
    box = Box(a - reach, a + reach);
  }
  return is_affine(group.form) ? image(box, table.blob_from_component[component - table.first_affine].matrix) : box;
}

}  // namespace isl::render
