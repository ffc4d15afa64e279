#include "tests/conformance/field_cases.h"

#include "tests/reference/random_scenes.h"
#include "tests/reference/reference_kernel.h"
#include "tests/reference/small_scenes.h"

#include <cmath>

namespace isl::conformance {
namespace {

using reference::RandomSource;
using scene::Vec3;

template <class Value>
struct Named {
  const char* name;
  Value value;
};

const std::vector<Named<scene::Component>>& skeletons() {
  static const std::vector<Named<scene::Component>> list = {
      {"point", reference::point({0.1, -0.2, 0.3}, 0.7)},
      {"segment", reference::segment({-0.5, 0, 0.1}, {0.6, 0.3, -0.2}, 0.4)},
      {"segment_on_axis", reference::segment({0, -1, 0}, {0, 1, 0}, 0.25)},
      {"segment_of_no_length", reference::segment({0.2, 0.2, 0}, {0.2, 0.2, 0}, 0.5)},
      {"cone", reference::cone({-0.4, 0.1, 0}, 0.5, {0.7, -0.2, 0.3}, 0.2)},
      {"cone_widening", reference::cone({0, 0, -0.6}, 0.1, {0, 0, 0.6}, 0.4)},
      {"cone_of_equal_radii", reference::cone({0, -0.5, 0}, 0.3, {0, 0.5, 0}, 0.3)},
      {"cone_inside_its_end", reference::cone({0, 0, 0}, 0.8, {0.3, 0, 0}, 0.2)}};
  return list;
}

const std::vector<Named<scene::Kernel>>& kernels() {
  static const std::vector<Named<scene::Kernel>> list = {
      {"povray", reference::kPovRay},
      {"quartic_1", reference::quartic(1)},
      {"quartic_4", reference::quartic(4)},
      {"quartic_100", reference::quartic(100)},
      {"gaussian_1", reference::gaussian(1)},
      {"gaussian_4", reference::gaussian(4)},
      {"gaussian_60", reference::gaussian(60)},
      {"gaussian_500", reference::gaussian(500)},
      {"soft_1", reference::soft(1)},
      {"soft_4", reference::soft(4)},
      {"soft_60", reference::soft(60)},
      {"metaball_a_fifth", reference::metaball(0.2)},  // its surface lies in the core: the junction is outside
      {"metaball_1", reference::metaball(1)},
      {"metaball_4", reference::metaball(4)},
      {"metaball_60", reference::metaball(60)},
      {"cauchy_1", reference::cauchy(1)},
      {"cauchy_4", reference::cauchy(4)},
      {"cauchy_60", reference::cauchy(60)},
      {"cauchy_500", reference::cauchy(500)}};
  return list;
}

std::vector<Named<scene::Transform>> transforms() {
  RandomSource random(2024);
  scene::Transform mirrored;
  mirrored.matrix.setScale(Vec3(-2, 1, 0.5));
  mirrored.inverse.setScale(Vec3(-0.5, 1, 2));
  return {{"identity", {}}, {"mirrored_scale", mirrored}, {"affine", reference::random_transform(random, 0.5)}};
}

double longest_stretch(const scene::Transform& transform) {
  double sum = 0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) sum += transform.matrix[row][column] * transform.matrix[row][column];
  }
  return std::sqrt(sum);
}

double reach_of(const FieldCase& field) {
  const double border = std::sqrt(static_cast<double>(reference::ReferenceKernel(field.kernel).support().hi));
  const scene::Component& c = field.component;
  const double in_component = std::max(c.a.length(), c.b.length()) + std::max(c.radius_a, c.radius_b) * border;
  const Vec3 shift(field.transform.matrix[3][0], field.transform.matrix[3][1], field.transform.matrix[3][2]);
  return in_component * longest_stretch(field.transform) + shift.length();
}

std::vector<FieldCase> all_cases() {
  std::vector<FieldCase> cases;
  const std::vector<Named<scene::Transform>> maps = transforms();
  for (const auto& skeleton : skeletons()) {
    for (const auto& kernel : kernels()) {
      for (const auto& map : maps) {
        for (const double strength : {1.0, -2.5}) {
          FieldCase field{
              std::string(skeleton.name) + "_" + kernel.name + "_" + map.name + (strength < 0 ? "_carving" : ""),
              skeleton.value, kernel.value, map.value, 0};
          field.component.strength = strength;
          field.reach = reach_of(field);
          cases.push_back(field);
        }
      }
    }
  }
  return cases;
}

/// A component as spheres along an axis. Its level set q = level² is the envelope of spheres of level times the radius,
/// which each touches where the normal's axial part is −slope·level; the end spheres show what leans outward of that.
struct Limb {
  explicit Limb(const scene::Component& component)
      : a(component.a),
        axis(component.skeleton == scene::Skeleton::point ? Vec3(0) : component.b - component.a),
        radius_a(component.radius_a),
        step(component.skeleton == scene::Skeleton::cone ? component.radius_b - component.radius_a : 0),
        has_axis(axis != Vec3(0)) {
    if (has_axis) {
      along = axis.normalized();
      slope = step / axis.length();
    }
  }
  [[nodiscard]] SurfaceWitness seen_from(double v, const Vec3& direction) const {
    return {a + axis * v, direction, radius_a + step * v};
  }
  /// The normal with that axial part, in the half-plane of `side`.
  [[nodiscard]] Vec3 flank_normal(const Vec3& side, double axial) const {
    const Vec3 across = (side - along * side.dot(along)).normalized();
    return along * axial + across * std::sqrt(1 - axial * axial);
  }

  Vec3 a, axis;
  double radius_a, step;
  bool has_axis;
  Vec3 along{0};
  double slope = 0;
};

}  // namespace

const std::vector<FieldCase>& field_cases() {
  static const std::vector<FieldCase> list = all_cases();
  return list;
}

std::vector<SurfaceWitness> surface_witnesses(const scene::Component& component, int count, double level) {
  RandomSource random(7);
  const Limb limb(component);
  std::vector<SurfaceWitness> witnesses;
  while (static_cast<int>(witnesses.size()) < count) {
    const Vec3 direction = random.direction();
    const double end = random.below(2), v = random.unit();
    if (!limb.has_axis) {
      witnesses.push_back({component.a, direction, component.radius_a});
    } else if (const double lean = direction.dot(limb.along), flank = -limb.slope * level;
               end == 1 ? lean > flank : lean < flank) {
      witnesses.push_back(limb.seen_from(end, direction));
    } else if (std::abs(flank) < 1) {
      witnesses.push_back(limb.seen_from(v, limb.flank_normal(direction, flank)));
    }
  }
  return witnesses;
}

std::vector<SurfaceWitness> end_witnesses(const scene::Component& component, int count) {
  const Limb limb(component);
  if (!limb.has_axis || std::abs(limb.slope) >= 1) return surface_witnesses(component, count);
  RandomSource random(8);
  std::vector<SurfaceWitness> witnesses;
  for (int i = 0; i < count; ++i)
    witnesses.push_back(limb.seen_from(i % 2, limb.flank_normal(random.direction(), -limb.slope)));
  return witnesses;
}

}  // namespace isl::conformance
