#include "renderer/shading/point_textures.h"

#include "renderer/fields/skeleton_coordinates.h"
#include "renderer/solids/solid_coordinates.h"

#include <cstdint>
#include <limits>

namespace isl::render {

Coordinates PointTextures::coordinates_of(const SurfacePlace& place, const Vec3& world) const {
  if (place.shape == scene::kNone) return {world.x, world.y};
  if (place.kind == scene::Object::Kind::solid)
    return solid_coordinates(database_.solids[place.shape], place.point, world);
  return skeleton_coordinates(database_, database_.blobs[place.shape], place.component, place.point, world);
}

void PointTextures::at(const SurfacePoint& point, std::vector<LitTexture>& lit) const {
  lit.clear();
  for (const TextureShare& share : point.textures) {
    const Material& material = materials_[share.texture];
    Rgb pigment = material.pigment;
    if (material.is_patterned) {
      const scene::Texture& texture = database_.texture(share.texture);
      values::Environment environment(noise_generator_, std::numeric_limits<std::uint64_t>::max(), &patterns_);
      Vec3 coordinates;
      if (coordinate_textures_.has(share.texture)) {
        coordinates = coordinates_of(share.surface, point.position).point();
        environment.set_coordinates(&coordinates);
      }
      const Vec3& place = texture.uv_mapping != 0 ? coordinates : share.place;
      pigment = rgb(patterns_.pigment_colour(texture.pigment, place, environment));
    }
    lit.push_back({&material, pigment, share.weight});
  }
}

}  // namespace isl::render
