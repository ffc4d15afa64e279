#include "interpreter/prune.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

namespace isl::interpreter {
namespace {

using scene::Database;
using scene::Object;

Object object(Object::Kind kind, std::uint32_t shape, scene::TextureId texture = scene::kNoTexture) {
  Object result;
  result.kind = kind;
  result.shape = shape;
  result.texture = texture;
  return result;
}

TEST(Prune, KeepsWhatGroupsOfGroupsReachAndRenumbersIt) {
  Database database;
  for (int i = 0; i < 4; ++i) database.solids.push_back({.radius_a = i + 1.0});
  for (int i = 0; i < 3; ++i) database.textures.push_back(test::plain_texture(database, {i + 1.0}, {}));
  database.groups.resize(3);
  database.groups[0].children = {object(Object::Kind::solid, 3, scene::TextureId{2})};
  database.groups[1].children = {object(Object::Kind::solid, 0)};  // not referred to
  database.groups[2].children = {object(Object::Kind::group, 0), object(Object::Kind::solid, 1)};
  database.objects = {object(Object::Kind::group, 2)};
  prune(database);
  ASSERT_EQ(database.groups.size(), 2u);
  ASSERT_EQ(database.solids.size(), 2u);
  ASSERT_EQ(database.textures.size(), 1u);
  EXPECT_EQ(database.objects[0].shape, 1u);
  EXPECT_EQ(database.groups[1].children[0].shape, 0u);
  EXPECT_EQ(database.solids[database.groups[0].children[0].shape].radius_a, 4);
  EXPECT_EQ(database.solids[database.groups[1].children[1].shape].radius_a, 2);
  EXPECT_EQ(database.texture(database.groups[0].children[0].texture).pigment.colour.red, 3);
}

TEST(Prune, RenumbersWhatSolidsHoldElsewhere) {
  Database database;
  database.polynomials = {{2, {1}}, {3, {2}}};
  database.triangles.resize(2);
  database.triangles[1].corners[0].x = 3;
  database.polygons = {{}, {{{4, 0, 0}}}};
  database.solids = {{.kind = scene::SolidKind::quadric, .detail = 0},
                     {.kind = scene::SolidKind::cubic, .detail = 1},
                     {.kind = scene::SolidKind::triangle, .detail = 1},
                     {.kind = scene::SolidKind::polygon, .detail = 1}};
  for (std::uint32_t i = 1; i < 4; ++i) database.objects.push_back(object(Object::Kind::solid, i));
  prune(database);
  ASSERT_EQ(database.polynomials.size(), 1u);
  ASSERT_EQ(database.triangles.size(), 1u);
  ASSERT_EQ(database.polygons.size(), 1u);
  EXPECT_EQ(database.polynomials[database.solids[0].detail].order, 3);
  EXPECT_EQ(database.triangles[database.solids[1].detail].corners[0].x, 3);
  EXPECT_EQ(database.polygons[database.solids[2].detail].points[0].x, 4);
}

TEST(Prune, KeepsWhatClipsBoundsAndIsShoneThrough) {
  Database database;
  database.solids = {{.radius_a = 1}, {.radius_a = 2}, {.radius_a = 3}, {.radius_a = 4}};
  database.groups.resize(4);
  for (std::uint32_t i = 1; i < 4; ++i) database.groups[i].children = {object(Object::Kind::solid, i)};
  Object clipped = object(Object::Kind::solid, 0);
  clipped.clip = scene::GroupId{3};
  clipped.bound = scene::GroupId{2};
  database.objects = {clipped};
  database.lights.resize(1);
  database.lights[0].projected_through = scene::GroupId{1};
  prune(database);
  ASSERT_EQ(database.groups.size(), 3u);
  const auto radius = [&](scene::GroupId group) {
    return database.solids[database.groups[scene::index(group)].children[0].shape].radius_a;
  };
  EXPECT_EQ(radius(database.objects[0].clip), 4);
  EXPECT_EQ(radius(database.objects[0].bound), 3);
  EXPECT_EQ(radius(database.lights[0].projected_through), 2);
}

TEST(Prune, RenumbersWhatComponentsReferTo) {
  Database database;
  database.kernels.resize(3);
  database.kernels[2].hardness = 7;
  database.transforms.resize(2);
  database.transforms[1].matrix[3][0] = 5;
  database.textures.resize(2);
  database.blobs.resize(2);
  scene::Component component;
  component.kernel = scene::KernelId{2};
  component.transform = scene::TransformId{1};
  component.texture = scene::TextureId{1};
  database.blobs[1].components = {component};
  database.objects = {object(Object::Kind::blob, 1)};
  prune(database);
  ASSERT_EQ(database.blobs.size(), 1u);
  EXPECT_EQ(database.textures.size(), 1u);
  const scene::Component& kept = database.blobs[0].components[0];
  EXPECT_EQ(database.kernels.at(scene::index(kept.kernel)).hardness, 7);
  EXPECT_EQ(database.transforms.at(scene::index(kept.transform)).matrix[3][0], 5);
  EXPECT_EQ(scene::index(kept.texture), 0u);
}

TEST(Prune, FollowsTexturesThroughMapsPatternsAndLayers) {
  Database database;
  database.solids.resize(3);
  database.solids[2].radius_a = 7;
  database.finishes.resize(2);
  database.finishes[1].phong = 5;
  database.transforms.resize(2);
  database.transforms[1].matrix[3][0] = 5;
  database.images.resize(2);
  database.images[1].file = "kept";
  // In every column, record 0 is not referred to; the others are a chain that ends in the solid.
  database.textures.resize(4);
  database.textures[1].pigment.pattern = scene::PigmentId{1};
  database.textures[2].below = scene::TextureId{1};
  database.textures[2].normal = scene::NormalId{1};
  database.textures[2].finish = scene::FinishId{1};
  database.textures[3].pattern = scene::TexturePatternId{1};
  database.texture_patterns.resize(2);
  database.texture_patterns[1].pattern.operands = scene::ImageId{1};
  database.texture_patterns[1].map = scene::TextureMapId{1};
  database.texture_maps = {{{0, scene::TextureId{0}}}, {{0, scene::TextureId{2}}}};
  database.pigments.resize(3);
  database.pigments[1].pattern.operands = scene::PigmentOperands{scene::PigmentId{2}};
  database.pigments[1].map = scene::PigmentMapId{1};
  database.pigments[2].pattern.operands = scene::ObjectOperands{1};
  database.pigments[2].pattern.warps = {scene::TransformId{1}};
  database.pigment_maps.resize(2);
  database.pigment_maps[1] = {{0.5, {}}};
  database.normals.resize(2);
  database.normals[1].slope_map = scene::SlopeMapId{1};
  database.slope_maps.resize(2);
  database.slope_maps[1] = {{0, 0, 3}};
  database.pattern_objects = {object(Object::Kind::solid, 0), object(Object::Kind::solid, 2)};
  database.interiors.resize(2);
  database.interiors[1].ior = 3;
  database.objects = {object(Object::Kind::solid, 1, scene::TextureId{3})};
  database.objects[0].interior = scene::InteriorId{1};
  prune(database);

  EXPECT_EQ(database.interiors.at(scene::index(database.objects[0].interior)).ior, 3);
  const scene::Texture& top = database.texture(database.objects[0].texture);
  const scene::TexturePattern& chosen = database.texture_patterns.at(scene::index(top.pattern));
  EXPECT_EQ(database.images.at(scene::index(std::get<scene::ImageId>(chosen.pattern.operands))).file, "kept");
  const scene::Texture& layer = database.texture(database.texture_maps.at(scene::index(chosen.map))[0].texture);
  EXPECT_EQ(database.finish(layer.finish).phong, 5);
  const scene::Normal& normal = database.normals.at(scene::index(layer.normal));
  EXPECT_EQ(database.slope_maps.at(scene::index(normal.slope_map))[0].slope, 3);
  const scene::PatternedPigment& pigment =
      database.pigments.at(scene::index(database.texture(layer.below).pigment.pattern));
  EXPECT_EQ(database.pigment_maps.at(scene::index(pigment.map))[0].value, 0.5);
  const auto inner = std::get<scene::PigmentOperands>(pigment.pattern.operands).pigment;
  const scene::Pattern& pattern = database.pigments.at(scene::index(inner)).pattern;
  EXPECT_EQ(database.transforms.at(scene::index(std::get<scene::TransformId>(pattern.warps[0]))).matrix[3][0], 5);
  const std::uint32_t asked = std::get<scene::ObjectOperands>(pattern.operands).object;
  EXPECT_EQ(database.solids.at(database.pattern_objects.at(asked).shape).radius_a, 7);
  EXPECT_EQ(database.solids.size(), 2u);
  EXPECT_EQ(database.textures.size(), 3u);
  EXPECT_EQ(database.pigments.size(), 2u);
}

TEST(Prune, KeepsWhatFunctionsHoldThatCallOneAnother) {
  Database database;
  database.transforms.resize(2);
  database.transforms[1].matrix[3][0] = 5;
  database.pigments.resize(3);
  database.pigments[1].colour.red = 7;
  database.pigments[2].pattern.kind = scene::PatternKind::function;
  database.pigments[2].pattern.operands = scene::FunctionOperands{scene::FunctionId{1}};

  auto moved = std::make_shared<scene::Function>();
  scene::Pattern pattern;
  pattern.warps = {scene::TransformId{1}};
  moved->body = scene::PatternFunction{pattern};
  moved->pattern_depth = 1;
  auto coloured = std::make_shared<scene::Function>();
  coloured->body = scene::PigmentFunction{{.pattern = scene::PigmentId{1}}};
  coloured->pattern_depth = 1;
  auto plain = std::make_shared<scene::Function>();
  plain->body = scene::Program{};
  auto caller = std::make_shared<scene::Function>();
  scene::Program calls;
  calls.callees = {moved, coloured, moved, plain};
  caller->body = calls;
  caller->pattern_depth = 1;
  database.functions = {coloured, caller};
  database.textures.resize(1);
  database.textures[0].pigment.pattern = scene::PigmentId{2};
  database.solids.resize(1);
  database.objects = {object(Object::Kind::solid, 0, scene::TextureId{0})};
  prune(database);

  ASSERT_EQ(database.functions.size(), 1u);
  const auto id = database.textures[0].pigment.pattern;
  EXPECT_EQ(std::get<scene::FunctionOperands>(database.pigments.at(scene::index(id)).pattern.operands).function,
            scene::FunctionId{0});
  const auto& callees = std::get<scene::Program>(database.functions[0]->body).callees;
  const auto& warps = std::get<scene::PatternFunction>(callees.at(0)->body).pattern.warps;
  EXPECT_EQ(database.transforms.at(scene::index(std::get<scene::TransformId>(warps[0]))).matrix[3][0], 5);
  const scene::Pigment& pigment = std::get<scene::PigmentFunction>(callees.at(1)->body).pigment;
  EXPECT_EQ(database.pigments.at(scene::index(pigment.pattern)).colour.red, 7);
  EXPECT_EQ(callees[0], callees[2]);
  EXPECT_EQ(callees[3], plain);
  EXPECT_EQ(database.transforms.size(), 1u);
  EXPECT_EQ(database.pigments.size(), 2u);
  // Other owners of the function still have it unchanged.
  EXPECT_EQ(std::get<scene::TransformId>(std::get<scene::PatternFunction>(moved->body).pattern.warps[0]),
            scene::TransformId{1});
}

}  // namespace
}  // namespace isl::interpreter
