#include "renderer/shading/point_textures.h"

#include <cstdint>
#include <limits>

namespace isl::render {

void PointTextures::at(std::span<const TextureShare> shares, std::vector<LitTexture>& lit) const {
  lit.clear();
  for (const TextureShare& share : shares) {
    const Material& material = materials_[share.texture];
    Rgb pigment = material.pigment;
    if (material.is_patterned) {
      const scene::Texture& texture = share.texture == scene::kNoTexture ? database_.default_texture : database_.texture(share.texture);
      values::Environment environment(noise_generator_, std::numeric_limits<std::uint64_t>::max(), &patterns_);
      pigment = rgb(patterns_.pigment_colour(texture.pigment, share.place, environment));
    }
    lit.push_back({&material, pigment, share.weight});
  }
}

}  // namespace isl::render
