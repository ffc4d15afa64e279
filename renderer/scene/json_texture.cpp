#include "renderer/scene/json_texture.h"

#include "renderer/scene/json_values.h"

namespace isl::scene {

Json texture_json(const Texture& t) {
  const Finish& f = t.finish;
  return {{"colour", colour(t.pigment.colour)},
          {"ambient", colour(f.ambient)},
          {"diffuse", f.diffuse},
          {"brilliance", f.brilliance},
          {"phong", f.phong},
          {"phong_size", f.phong_size},
          {"specular", f.specular},
          {"roughness", f.roughness}};
}

}  // namespace isl::scene
