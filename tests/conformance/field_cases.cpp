#include "tests/conformance/field_cases.h"

#include "renderer/reference/reference_kernel.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"

#include <algorithm>
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

struct Shape {
  const char* name;
  scene::Component component;
  Vec3 third_corner{0};
};

/// The kernel with the widest support reaches 4.25 radii. The circles are wide enough that this stays clear of the
/// axis, where the field would have a crease, and of the ring's other side.
const std::vector<Shape>& skeletons() {
  static const std::vector<Shape> list = {
      {"point", reference::point({0.1, -0.2, 0.3}, 0.7)},
      {"segment", reference::segment({-0.5, 0, 0.1}, {0.6, 0.3, -0.2}, 0.4)},
      {"segment_on_axis", reference::segment({0, -1, 0}, {0, 1, 0}, 0.25)},
      {"segment_of_no_length", reference::segment({0.2, 0.2, 0}, {0.2, 0.2, 0}, 0.5)},
      {"cone", reference::cone({-0.4, 0.1, 0}, 0.5, {0.7, -0.2, 0.3}, 0.2)},
      {"cone_widening", reference::cone({0, 0, -0.6}, 0.1, {0, 0, 0.6}, 0.4)},
      {"cone_of_equal_radii", reference::cone({0, -0.5, 0}, 0.3, {0, 0.5, 0}, 0.3)},
      {"cone_inside_its_end", reference::cone({0, 0, 0}, 0.8, {0.3, 0, 0}, 0.2)},
      {"box", reference::box({-0.3, -0.2, 0.1}, {0.5, 0.1, 0.7}, 0.3)},
      {"box_of_no_thickness", reference::box({-0.6, 0.2, -0.4}, {0.5, 0.2, 0.7}, 0.15)},
      {"triangle", reference::triangle({-0.5, 0.1, 0}, {0.6, -0.2, 0.3}, 0.2), {0.1, 0.7, -0.4}},
      {"triangle_obtuse", reference::triangle({0.1, 0.15, 0.05}, {0.9, 0, 0}, 0.2), {-0.8, 0.1, -0.1}},
      {"triangle_needle", reference::triangle({-0.8, 0.1, 0.2}, {0.7, -0.3, 0.1}, 0.25), {0.7, -0.293, 0.107}},
      {"circle", reference::circle({0, 0, 0}, {0, 1, 0}, 0.9, 0.12)},
      {"circle_tilted", reference::circle({0.1, -0.2, 0.3}, {0.36, 0.48, 0.8}, 1.1, 0.15)},
      {"disc", reference::disc({0, 0, 0}, {0, 1, 0}, 0.6, 0.2)},
      {"disc_tilted", reference::disc({0.1, -0.2, 0.3}, {0.36, 0.48, 0.8}, 0.8, 0.1)},
      {"disc_narrow", reference::disc({-0.1, 0.2, 0}, {0.6, 0, 0.8}, 0.1, 0.3)},
      {"plane", reference::half_space({0.1, 0.2, -0.3}, {0.48, -0.6, 0.64}, 0.3)},
      {"sheet", reference::sheet({0.1, 0.2, -0.3}, {0.48, -0.6, 0.64}, 0.3)}};
  return list;
}

/// Curves of any size: a convolved circle has no crease on its axis.
const std::vector<Shape>& curves() {
  static const std::vector<Shape> list = {
      {"segment", reference::segment({-0.5, 0, 0.1}, {0.6, 0.3, -0.2}, 0.4)},
      {"segment_long", reference::segment({-1.5, -0.9, 0.3}, {1.6, 0.7, -0.2}, 0.1)},
      {"segment_short", reference::segment({0.2, 0.2, 0}, {0.21, 0.19, 0.02}, 0.5)},
      {"circle", reference::circle({0, 0, 0}, {0, 1, 0}, 0.9, 0.12)},
      {"circle_narrow", reference::circle({0.1, -0.2, 0.3}, {0.36, 0.48, 0.8}, 0.3, 0.25)},
      {"circle_small", reference::circle({0.1, 0, 0}, {1, 0, 0}, 0.02, 0.4)}};
  return list;
}

/// Every kernel soft, usual and hard, and some kernels at the hardnesses where their formulas change.
const std::vector<Named<scene::Kernel>>& kernels() {
  static const std::vector<Named<scene::Kernel>> list = {
#define ISL_KERNEL(word, Type) \
  {#word "_1", reference::word(1)}, {#word "_4", reference::word(4)}, {#word "_60", reference::word(60)},
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL
      {"povray", reference::kPovRay},
      {"quartic_100", reference::quartic(100)},
      {"gaussian_500", reference::gaussian(500)},
      {"metaball_a_fifth", reference::metaball(0.2)},  // its surface is in the core, and the junction outside
      {"cauchy_500", reference::cauchy(500)}};
  return list;
}

/// The kernels that can be convolved.
const std::vector<Named<scene::Kernel>>& windows() {
  static const std::vector<Named<scene::Kernel>> list = {
      {"quartic_1", reference::quartic(1)},     {"quartic_4", reference::quartic(4)},
      {"quartic_100", reference::quartic(100)}, {"cauchy_1", reference::cauchy(1)},
      {"cauchy_4", reference::cauchy(4)},       {"cauchy_60", reference::cauchy(60)}};
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

/// The radius of a ball about the origin of the component's space that holds the skeleton or, for one without end, the
/// part that is tested.
double skeleton_reach(const FieldCase& field) {
  const scene::Component& c = field.component;
  switch (c.skeleton) {
    case scene::Skeleton::circle:
    case scene::Skeleton::disc: return c.a.length() + c.radius_b;
    case scene::Skeleton::plane:
    case scene::Skeleton::sheet: return c.a.length() + 1;
    case scene::Skeleton::triangle: return std::max({c.a.length(), c.b.length(), field.third_corner.length()});
    case scene::Skeleton::box: {
      const auto farther = [&](int i) { return std::max(std::abs(c.a[i]), std::abs(c.b[i])); };
      return Vec3(farther(0), farther(1), farther(2)).length();
    }
    default: return std::max(c.a.length(), c.b.length());
  }
}

double reach_of(const FieldCase& field) {
  const double border = std::sqrt(static_cast<double>(reference::ReferenceKernel(field.kernel).support().hi()));
  const scene::Component& c = field.component;
  const double radius = c.skeleton == scene::Skeleton::cone ? std::max(c.radius_a, c.radius_b) : c.radius_a;
  const double in_component = skeleton_reach(field) + radius * border;
  const Vec3 shift(field.transform.matrix[3][0], field.transform.matrix[3][1], field.transform.matrix[3][2]);
  return in_component * longest_stretch(field.transform) + shift.length();
}

/// A skeleton with a kernel in every space, named after both.
void add_cases(const Shape& skeleton, const scene::Kernel& kernel, const std::string& name,
               std::vector<FieldCase>& cases) {
  static const std::vector<Named<scene::Transform>> maps = transforms();
  for (const auto& map : maps) {
    // A negative field carves in the same way in any space, so it is tested only in the hardest.
    for (const double strength : {1.0, -2.5}) {
      if (strength < 0 && &map != &maps.back()) continue;
      FieldCase field{name + "_" + map.name + (strength < 0 ? "_carving" : ""), skeleton.component, kernel, map.value,
                      skeleton.third_corner};
      field.component.strength = strength;
      field.reach = reach_of(field);
      cases.push_back(field);
    }
  }
}

std::vector<FieldCase> all_cases() {
  std::vector<FieldCase> cases;
  for (const auto& skeleton : skeletons()) {
    for (const auto& kernel : kernels())
      add_cases(skeleton, kernel.value, std::string(skeleton.name) + "_" + kernel.name, cases);
  }
  for (const auto& kernel : windows()) {
    const auto named = [&](const Shape& shape) { return std::string("convolved_") + shape.name + "_" + kernel.name; };
    for (const Shape& curve : curves()) add_cases(curve, reference::convolved(kernel.value), named(curve), cases);
    const Shape& sheet = skeletons().back();
    add_cases(sheet, reference::over_sheets(kernel.value), named(sheet), cases);
  }
  return cases;
}

}  // namespace

const std::vector<FieldCase>& field_cases() {
  static const std::vector<FieldCase> list = all_cases();
  return list;
}

bool is_function_of_distance(const FieldCase& field) { return field.kernel.mode != scene::FieldMode::convolution; }

scene::Database blob_of(const FieldCase& field, double threshold) {
  scene::Database database;
  database.kernels.push_back(field.kernel);
  database.transforms.push_back(field.transform);
  scene::Component alone = field.component;
  alone.kernel = scene::KernelId{0};
  alone.transform = scene::TransformId{0};
  database.blobs.push_back({threshold, {alone}, {{}}, {field.third_corner}});
  return database;
}

}  // namespace isl::conformance
