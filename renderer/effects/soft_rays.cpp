#include "renderer/effects/soft_rays.h"

#include <algorithm>
#include <numbers>

namespace isl::render {

const scene::Statement* find_statement(const scene::Database& database, const scene::StatementKind& kind) {
  const auto found = std::ranges::find(database.statements, &kind, &scene::Statement::kind);
  return found == database.statements.end() ? nullptr : &*found;
}

std::function<void(const SceneUse&, Requests&, std::string_view&)> find_soft_rays(const scene::StatementKind& kind) {
  return [&kind](const SceneUse& use, Requests& requests, std::string_view& /*reason*/) {
    if (const scene::Statement* const statement = find_statement(use.database(), kind))
      requests.add(std::string("`") + std::string(kind.word) + "`", statement->origin);
  };
}

Ray ray_from(const PathBatch& batch, std::uint32_t path, const ShadingPoint& point, const Vec3& direction,
             double reach) {
  const Hit& hit = batch.hits[path];
  return {point.position, direction, reach, batch.rays[path].path_length + hit.t, hit.start()};
}

Rgb thrown_back(const SurfaceBlock& block, const ShadingPoint& point, const Vec3& direction) {
  Rgb sum(0);
  for (const LitTexture& texture : point.textures) {
    const double cosine = block.normal_of(point, texture).dot(direction);
    if (cosine <= 0) continue;
    sum += texture.pigment * texture.let_through * (texture.material->diffuse * texture.weight * cosine);
  }
  return sum / std::numbers::pi;
}

}  // namespace isl::render
