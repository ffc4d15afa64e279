// Bumps: `normal` bends the normal of each layer of a texture (patterns/bumps.cpp). The integrator asks for the bent
// normals where this effect is called for.
#include "renderer/effects/effect.h"

namespace isl::render {

Effect normal() {
  return {.name = "normal",
          .summary = "bumps",
          .from_quality = 8,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "no texture has a `normal`";
                for (const Use<scene::Texture>& texture : use.textures()) {
                  if (texture.record->normal == scene::kNoNormal) continue;
                  const scene::Normal& bumps = use.database().normals[index(texture.record->normal)];
                  if (bumps.pattern.kind == scene::PatternKind::plain) continue;
                  requests.add("`normal`", bumps.pattern.said_at, texture.user);
                }
              },
          .stages = {.bumps = true}};
}

}  // namespace isl::render
