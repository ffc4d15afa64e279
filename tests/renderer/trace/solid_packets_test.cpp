// Rays that meet solids and combinations in packets have the same hits, to the last bit, as the same rays alone.
#include "renderer/trace/tracer.h"
#include "tests/renderer/solids/solid_oracle.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace isl::render {
namespace {

using scene::Solid;
using scene::SolidKind;
using test::Random;

/// An ellipsoid, cylinder, cone, paraboloid, hyperboloid or any other quadric, which is appended to the database.
Solid any_quadric(scene::Database& database, Random& random) {
  scene::Polynomial quadric{2, std::vector<double>(10, 0)};
  const double form = random.uniform(0, 6);
  for (const std::size_t square : {0, 4, 7}) quadric.coefficients[square] = random.uniform(0.5, 3);
  quadric.coefficients[9] = random.uniform(-1.5, -0.2);
  if (form < 1) quadric.coefficients[4] = 0;
  if (form >= 1 && form < 3) quadric.coefficients[4] *= -1;
  if (form >= 2 && form < 3) quadric.coefficients[9] = 0;
  if (form >= 3 && form < 4) quadric.coefficients[4] = 0, quadric.coefficients[6] = 1;
  if (form >= 4 && form < 5) {
    for (double& c : quadric.coefficients) c += random.uniform(-1, 1);
  }
  database.polynomials.push_back(quadric);
  return {.kind = SolidKind::quadric, .detail = static_cast<std::uint32_t>(database.polynomials.size() - 1)};
}

/// A quartic with some of its coefficients, bounded or not, which is appended to the database.
Solid any_quartic(scene::Database& database, Random& random) {
  scene::Polynomial quartic{4, std::vector<double>(35, 0)};
  const double share = random.uniform(0, 1);
  for (double& c : quartic.coefficients) {
    if (random.uniform(0, 1) < share) c = random.uniform(-1, 1);
  }
  if (random.uniform(0, 2) < 1) {
    for (const std::size_t power : {0, 20, 30}) quartic.coefficients[power] = random.uniform(2, 4);
  }
  quartic.coefficients[34] = random.uniform(-1, 0.2);
  database.polynomials.push_back(quartic);
  return {.kind = SolidKind::quartic, .detail = static_cast<std::uint32_t>(database.polynomials.size() - 1)};
}

Solid any_solid(scene::Database& database, Random& random, SolidKind kind) {
  if (kind == SolidKind::quadric) return any_quadric(database, random);
  if (kind == SolidKind::quartic) return any_quartic(database, random);
  if (kind == SolidKind::box) {
    Solid box{.kind = kind, .a = random.in_cube(1)};
    box.b = box.a + Vec3(random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1));
    if (random.uniform(0, 8) < 1) box.b.y = box.a.y;  // an open surface
    return box;
  }
  if (kind == SolidKind::disc) {
    const double radius = random.uniform(0.2, 1);
    return {.kind = kind,
            .a = random.in_cube(1),
            .b = random.direction(),
            .radius_a = radius,
            .radius_b = random.uniform(0, 2) < 1 ? 0 : radius / 2};
  }
  if (kind == SolidKind::torus) {
    const double radius = random.uniform(0.2, 1);
    return {.kind = kind, .radius_a = radius, .radius_b = radius * random.uniform(0.05, 1.1)};
  }
  Solid solid = test::random_solid(random, kind);
  solid.open = kind == SolidKind::cylinder && random.uniform(0, 3) < 1;
  return solid;
}

scene::Transform random_place(Random& random) {
  scene::Transform place;
  const Vec3 turn = random.in_cube(3);
  place.matrix.rotate(turn);
  place.matrix.scale(Vec3(random.uniform(0.5, 2), random.uniform(0.5, 2), random.uniform(0.5, 2)));
  place.matrix.translate(random.in_cube(1));
  place.inverse = place.matrix.inverse();
  return place;
}

/// `count` solids; some of them touch each other's faces.
scene::Database random_scene(Random& random, int count) {
  constexpr SolidKind kKinds[] = {SolidKind::plane,    SolidKind::sphere, SolidKind::box,
                                  SolidKind::cylinder, SolidKind::disc,   SolidKind::cone,
                                  SolidKind::quadric,  SolidKind::torus,  SolidKind::quartic};
  scene::Database database;
  for (int i = 0; i < count; ++i) {
    const auto kind = kKinds[static_cast<int>(random.uniform(0, std::size(kKinds)))];
    Solid solid = any_solid(database, random, kind);
    scene::Object object{.shape = static_cast<std::uint32_t>(database.solids.size())};
    object.inverse = random.uniform(0, 4) < 1;
    if (random.uniform(0, 2) < 1) object.parent_from_object = random_place(random);
    if (kind == SolidKind::box && !database.solids.empty() && database.solids.back().kind == SolidKind::box) {
      solid.a = database.solids.back().a;
      if (!(solid.b.x > solid.a.x && solid.b.y > solid.a.y && solid.b.z > solid.a.z)) solid.b = solid.a + Vec3(0.5);
      object.parent_from_object = database.objects.back().parent_from_object;
      if (random.uniform(0, 2) < 1) {
        // All its faces, in a space of another scale: they coincide up to rounding, and either may be the nearer one.
        const double scale = random.uniform(0.3, 3);
        solid.b = database.solids.back().b;
        solid.a /= scale;
        solid.b /= scale;
        scene::Transform& place = object.parent_from_object;
        scene::Matrix own;
        own.setScale(scale);
        place.matrix = own * place.matrix;
        place.inverse = place.matrix.inverse();
      }
    }
    database.solids.push_back(solid);
    database.objects.push_back(object);
  }
  return database;
}

Ray random_ray(Random& random) {
  Ray ray;
  ray.origin = random.in_cube(3);
  ray.direction = random.direction();
  const double along = random.uniform(0, 6);
  if (along < 1) {  // along an axis
    ray.direction = Vec3(0);
    ray.direction[static_cast<int>(3 * along)] = along < 0.5 ? 1 : -1;
  }
  if (random.uniform(0, 3) < 1) ray.t_max = random.uniform(0.1, 4);
  return ray;
}

bool equal_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

struct Traced {
  std::vector<Hit> hits;
  std::vector<std::uint8_t> occluded;
};

Traced traced(const scene::Database& database, bool packets, RayKind kind, const std::vector<Ray>& rays) {
  TracerOptions options;
  options.packets = packets;
  const Tracer tracer(database, options);
  Traced result{std::vector<Hit>(rays.size()), std::vector<std::uint8_t>(rays.size())};
  TraceCounters counters;
  tracer.first_hits(rays, result.hits, counters, kind);
  tracer.occlusions(rays, result.occluded, counters);
  return result;
}

/// Returns the hits of the rays. Only queries ask whether a ray comes out of a solid, which single rays find out.
std::vector<Hit> expect_same(const scene::Database& database, RayKind kind, const std::vector<Ray>& rays) {
  const Traced alone = traced(database, false, kind, rays), together = traced(database, true, kind, rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit &a = alone.hits[i], &b = together.hits[i];
    EXPECT_TRUE(equal_bits(a.t, b.t)) << "ray " << i << ": " << a.t << " and " << b.t;
    EXPECT_EQ(a.instance, b.instance) << "ray " << i;
    EXPECT_EQ(alone.occluded[i], together.occluded[i]) << "ray " << i;
    if (a.is_miss() || b.is_miss()) continue;
    EXPECT_EQ(a.part, b.part) << "ray " << i;
    EXPECT_EQ(a.leaf, b.leaf) << "ray " << i;
    EXPECT_EQ(a.from_inside, b.from_inside) << "ray " << i;
  }
  return together.hits;
}

std::vector<Hit> expect_same(const scene::Database& database, const std::vector<Ray>& rays) {
  expect_same(database, RayKind::image, rays);
  return expect_same(database, RayKind::query, rays);
}

scene::Object leaf_of_combination(scene::Database& database, Random& random) {
  constexpr SolidKind kKinds[] = {SolidKind::plane, SolidKind::sphere,  SolidKind::box,   SolidKind::cylinder,
                                  SolidKind::cone,  SolidKind::quadric, SolidKind::torus, SolidKind::quartic};
  const auto kind = kKinds[static_cast<int>(random.uniform(0, std::size(kKinds)))];
  Solid solid = any_solid(database, random, kind);
  solid.open = false;  // combinations with open tubes do not go in packets
  if (kind == SolidKind::box) {
    // Corners on a grid, so that many faces coincide.
    const auto on_grid = [&] { return std::round(random.uniform(-2, 2)) / 2; };
    solid.a = {on_grid(), on_grid(), on_grid()};
    solid.b = solid.a + Vec3(0.5 + std::abs(on_grid()), 0.5 + std::abs(on_grid()), 0.5);
  }
  scene::Object object{.shape = static_cast<std::uint32_t>(database.solids.size())};
  if (kind == SolidKind::box) {
    // The same box in a space of another scale: the faces then coincide with others up to rounding.
    const double scale = random.uniform(0.3, 3);
    scene::Matrix& matrix = object.parent_from_object.matrix;
    matrix.setScale(scale);
    object.parent_from_object.inverse = matrix.inverse();
    solid.a /= scale;
    solid.b /= scale;
  } else if (random.uniform(0, 2) < 1) {
    object.parent_from_object = random_place(random);
  }
  database.solids.push_back(solid);
  return object;
}

scene::Object group_of(scene::Database& database, scene::Operation operation, std::vector<scene::Object> children) {
  database.groups.push_back({.operation = operation, .children = std::move(children)});
  scene::Object object{.kind = scene::Object::Kind::group};
  object.shape = static_cast<std::uint32_t>(database.groups.size() - 1);
  return object;
}

scene::Object combination(scene::Database& database, Random& random, int depth) {
  scene::Object object;
  if (depth == 0 || random.uniform(0, 5) < 1) {
    object = leaf_of_combination(database, random);
  } else {
    std::vector<scene::Object> children;
    const int count = 2 + static_cast<int>(random.uniform(0, 2));
    for (int i = 0; i < count; ++i) children.push_back(combination(database, random, depth - 1));
    using enum scene::Operation;
    constexpr scene::Operation kOperations[] = {intersect, subtract, merge, unite};
    object = group_of(database, kOperations[static_cast<int>(random.uniform(0, 4))], std::move(children));
    if (random.uniform(0, 4) < 1) object.parent_from_object = random_place(random);
  }
  object.inverse = random.uniform(0, 8) < 1;
  if (random.uniform(0, 8) < 1) {
    const scene::Object clip = group_of(database, scene::Operation::intersect, {leaf_of_combination(database, random)});
    object.clip = scene::GroupId{clip.shape};
  }
  return object;
}

/// Combinations among a few solids, whose faces may coincide with theirs.
scene::Database random_combinations(Random& random) {
  scene::Database database = random_scene(random, 2);
  for (int i = 0; i < 4; ++i) database.objects.push_back(leaf_of_combination(database, random));
  for (int i = 0; i < 2; ++i) {
    scene::Object object = group_of(
        database, scene::Operation::intersect,
        {combination(database, random, 2), combination(database, random, static_cast<int>(random.uniform(0, 3)))});
    if (random.uniform(0, 2) < 1) object.parent_from_object = random_place(random);
    database.objects.push_back(object);
  }
  return database;
}

struct Met {
  int hits = 0, again = 0;
};

/// Traces random rays, and rays from the surfaces that they meet.
Met expect_same_from_surfaces(const scene::Database& database, Random& random) {
  Met met;
  std::vector<Ray> rays;
  while (rays.size() < 203) rays.push_back(random_ray(random));
  const std::vector<Hit> found = expect_same(database, rays);
  std::vector<Ray> next;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (found[i].is_miss()) continue;
    ++met.hits;
    Ray ray = random_ray(random);
    ray.origin = rays[i].origin + rays[i].direction * found[i].t;
    ray.path_length = found[i].t;
    ray.start = found[i].start();
    next.push_back(ray);
  }
  for (const Hit& hit : expect_same(database, next)) met.again += hit.is_miss() ? 0 : 1;
  return met;
}

TEST(SolidPackets, HitWhatSingleRaysHitAlsoFromSurfaces) {
  Random random(21);
  Met all;
  for (int scene = 0; scene < 300; ++scene) {
    SCOPED_TRACE(scene);
    const Met met = expect_same_from_surfaces(random_scene(random, 1 + scene % 12), random);
    all.hits += met.hits;
    all.again += met.again;
    if (HasFailure()) return;
  }
  EXPECT_GT(all.hits, 10000);
  EXPECT_GT(all.again, 3000);
}

TEST(SolidPackets, HitWhatSingleRaysHitInCombinations) {
  Random random(22);
  Met all;
  for (int scene = 0; scene < 2000; ++scene) {
    SCOPED_TRACE(scene);
    const Met met = expect_same_from_surfaces(random_combinations(random), random);
    all.hits += met.hits;
    all.again += met.again;
    if (HasFailure()) return;
  }
  EXPECT_GT(all.hits, 20000);
  EXPECT_GT(all.again, 5000);
}

}  // namespace
}  // namespace isl::render
