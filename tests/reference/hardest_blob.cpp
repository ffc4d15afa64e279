#include "tests/reference/hardest_blob.h"

#include <iterator>

namespace isl::reference {
namespace {

constexpr double kHardest[] = {500, 343, 1e-12, 1e-170, 1e-300};

scene::TransformId stretched(RandomSource& random, scene::Database& database) {
  scene::Transform scaling;
  scaling.matrix.setScale(scene::Vec3(1e4, 1, 1e-4));
  scaling.inverse.setScale(scene::Vec3(1e-4, 1, 1e4));
  database.transforms.push_back(then(scaling, random_transform(random, 0.2)));
  return static_cast<scene::TransformId>(database.transforms.size() - 1);
}

}  // namespace

scene::Database hardest_blob(RandomSource& random, std::uint64_t number) {
  const double hardness = kHardest[number % std::size(kHardest)];
  scene::Database database = random_blob(
      random, {.components = 4, .negatives = false, .transforms = false, .half_space = random.below(2) == 0});
  for (scene::Kernel& kernel : database.kernels) {
    if (kernel.meaning == scene::RadiusMeaning::surface) kernel.hardness = hardness;
  }
  scene::Blob& blob = database.blobs.front();
  for (std::size_t i = 0, n = blob.components.size(); i < n; ++i) {
    if (random.below(3) == 0) blob.components[i].transform = stretched(random, database);
    scene::Component carving = blob.components[i];
    carving.strength *= -(1 - 1e-9);
    blob.components.push_back(carving);
    blob.origins.push_back({});
  }
  return database;
}

}  // namespace isl::reference
