// Textures that are evaluated in surface coordinates: each component of a blob has its own, and the results are
// blended.
#include "renderer/render.h"
#include "renderer/shading/point_textures.h"
#include "tests/support/patterns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace isl::render::test {
namespace {

using scene::Skeleton;

/// Texture 0: red is u and green is 0, from a gradient along x from black to red over one unit, with `uv_mapping`.
scene::Database with_gradient() {
  scene::Database database;
  database.pigments.push_back({.pattern = gradient_along({1, 0, 0}), .map = scene::PigmentMapId{0}});
  database.pigment_maps = {{{0, {}}, {1, {{1, 0, 0}}}}};
  database.textures.push_back({.pigment = {.pattern = scene::PigmentId{0}}, .uv_mapping = 1});
  database.kernels.push_back({scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 4});
  return database;
}

void add_blob(scene::Database& database, const std::vector<scene::Component>& components, scene::TextureId texture) {
  scene::Blob blob;
  for (const scene::Component& component : components) {
    blob.components.push_back(component);
    blob.origins.push_back({});
  }
  database.objects.push_back({.kind = scene::Object::Kind::blob,
                              .shape = static_cast<std::uint32_t>(database.blobs.size()),
                              .texture = texture});
  database.blobs.push_back(blob);
}

scene::Component limb(const Vec3& a, const Vec3& b, scene::TextureId texture = scene::kNoTexture) {
  scene::Component c;
  c.a = a;
  c.b = b;
  c.radius_a = c.radius_b = 0.5;
  c.skeleton = a == b ? Skeleton::point : Skeleton::segment;
  c.texture = texture;
  return c;
}

struct Seen {
  SurfacePoint point;
  std::vector<LitTexture> lit;

  [[nodiscard]] Rgb colour() const {
    Rgb sum(0);
    for (const LitTexture& texture : lit) sum += texture.pigment * texture.weight;
    return sum;
  }
};

/// The surface along z from −10.
Seen seen_at(const scene::Database& database, double x, double y) {
  const Tracer tracer(database, {});
  Ray ray;
  ray.origin = {x, y, -10};
  ray.direction = {0, 0, 1};
  Hit hit;
  TraceCounters counters;
  tracer.first_hits({&ray, 1}, {&hit, 1}, counters);
  Seen seen;
  if (hit.is_miss()) return seen;
  tracer.surface_at(ray, hit, seen.point);
  Charge unlimited;
  EXPECT_TRUE(PointTextures(database).append(seen.point, seen.lit, unlimited));
  return seen;
}

constexpr double kSingle = 1e-6;  // colours have single precision

TEST(UvMapping, GivesALimbsColourByWhereAlongItThePointIs) {
  scene::Database database = with_gradient();
  add_blob(database, {limb({0, -2, 0}, {0, 2, 0}, scene::TextureId{0})}, scene::kNoTexture);
  EXPECT_NEAR(seen_at(database, 0.1, -1).colour().x, 0.25, kSingle);
  EXPECT_NEAR(seen_at(database, -0.2, 1.2).colour().x, 0.8, kSingle);
}

TEST(UvMapping, BlendsTheColoursThatEachComponentHasAtItsOwnCoordinates) {
  // At the height 1, u is 3/4 on the first limb and 1/2 on the other; both are equally near.
  for (const bool is_of_blob : {false, true}) {
    scene::Database database = with_gradient();
    const scene::TextureId own = is_of_blob ? scene::kNoTexture : scene::TextureId{0};
    add_blob(database, {limb({-0.4, -2, 0}, {-0.4, 2, 0}, own), limb({0.4, 0, 0}, {0.4, 2, 0}, own)},
             is_of_blob ? scene::TextureId{0} : scene::kNoTexture);
    const Seen seen = seen_at(database, 0, 1);
    ASSERT_EQ(seen.lit.size(), 2u);
    EXPECT_NEAR(seen.lit[0].weight, 0.5, 1e-12);
    const auto [low, high] = std::minmax(seen.lit[0].pigment.x, seen.lit[1].pigment.x);
    EXPECT_NEAR(low, 0.5, kSingle);
    EXPECT_NEAR(high, 0.75, kSingle);
    EXPECT_NEAR(seen.colour().x, 0.625, kSingle);
  }
}

TEST(UvMapping, BlendsWithACarvingComponentToo) {
  scene::Database database = with_gradient();
  scene::Component carver = limb({0.45, -1, -0.4}, {0.45, 3, -0.4}, scene::TextureId{0});
  carver.strength = -0.5;
  add_blob(database, {limb({0, -2, 0}, {0, 2, 0}, scene::TextureId{0}), carver}, scene::kNoTexture);
  const Seen seen = seen_at(database, 0.2, 1);
  ASSERT_EQ(seen.lit.size(), 2u);
  // u is 3/4 and 1/2; the shares follow from the colour between.
  const double share = (seen.colour().x - 0.5) / 0.25;
  const auto& first = seen.lit[0].pigment.x > 0.6 ? seen.lit[0] : seen.lit[1];
  EXPECT_NEAR(share, first.weight, 1e-5);
  EXPECT_GT(share, 0.5);
  EXPECT_LT(share, 0.99);
}

TEST(UvMapping, LeavesOtherTexturesShared) {
  scene::Database database = with_gradient();
  database.textures.push_back({.pigment = {{0, 1, 0}}});
  const auto plain = scene::TextureId{1};
  add_blob(database, {limb({-0.4, -2, 0}, {-0.4, 2, 0}, plain), limb({0.4, 0, 0}, {0.4, 2, 0}, plain)},
           scene::TextureId{0});
  EXPECT_EQ(seen_at(database, 0, 1).lit.size(), 1u);
}

TEST(UvMapping, OfAPigmentAloneIsThatOfItsTexture) {
  scene::Database database = with_gradient();
  database.textures[0].uv_mapping = 0;
  database.pigments[0].pattern.uv_mapping = true;
  add_blob(database, {limb({0, -2, 0}, {0, 2, 0})}, scene::TextureId{0});
  EXPECT_NEAR(seen_at(database, 0.1, -1).colour().x, 0.25, kSingle);
}

TEST(UvMapping, OfASphereInAMovedObjectMovesAlong) {
  scene::Database database = with_gradient();
  database.solids.push_back({.kind = scene::SolidKind::sphere, .a = {0, 0, 0}, .radius_a = 1});
  scene::Object ball{.shape = 0, .texture = scene::TextureId{0}};
  ball.parent_from_object.matrix.setTranslation(Vec3(3, 0, 0));
  ball.parent_from_object.inverse.setTranslation(Vec3(-3, 0, 0));
  database.objects.push_back(ball);
  EXPECT_NEAR(seen_at(database, 3, 0).colour().x, 0.75, kSingle);  // at −z
}

TEST(UvMapping, OfWhatHasNoCoordinatesIsTheWorlds) {
  scene::Database database = with_gradient();
  database.solids.push_back({.kind = scene::SolidKind::cylinder, .a = {0, -1, 0}, .b = {0, 1, 0}, .radius_a = 1});
  scene::Object tube{.shape = 0, .texture = scene::TextureId{0}};
  tube.parent_from_object.matrix.setTranslation(Vec3(3, 0, 0));
  tube.parent_from_object.inverse.setTranslation(Vec3(-3, 0, 0));
  database.objects.push_back(tube);
  EXPECT_NEAR(seen_at(database, 3.3, 0).colour().x, 0.3, kSingle);
}

}  // namespace
}  // namespace isl::render::test
