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
  database.groups[1].children = {object(Object::Kind::solid, 0)};  // nobody's
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

}  // namespace
}  // namespace isl::interpreter
