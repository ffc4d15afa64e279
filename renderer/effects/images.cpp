// Images from files, and of functions, in pigments, normals and textures. The front door prepares them where this
// effect is called for (render.cpp); the patterns look them up (patterns/kinds/images.cpp).
#include "renderer/effects/effect.h"
#include "renderer/effects/pigment_search.h"
#include "renderer/patterns/kinds/pattern_kind.h"

#include <algorithm>
#include <variant>

namespace isl::render {
namespace {

bool is_of_image(const scene::Pattern& pattern) { return std::holds_alternative<scene::ImageId>(pattern.operands); }

/// Patterns of images become plain: pigments get a mean colour, bumps are flat, and the first of the textures is taken.
void without_images(scene::Database& database) {
  for (scene::PatternedPigment& pigment : database.pigments) {
    if (!is_of_image(pigment.pattern)) continue;
    pigment.colour = stand_in(database, pigment);
    pigment.pattern = {};
  }
  for (scene::Normal& normal : database.normals) {
    if (is_of_image(normal.pattern)) normal.pattern = {};
  }
  for (scene::TexturePattern& choice : database.texture_patterns) {
    if (is_of_image(choice.pattern)) choice.pattern = {};
  }
}

}  // namespace

Effect images() {
  return {.name = "images",
          .summary = "images in pigments, normals and textures",
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "no texture has an image";
                for (const Use<scene::Image>& image : use.images())
                  requests.add("an image", image.record->said_at, image.user);
                // Functions hold patterns of their own. A scene keeps only images in use: the rest is theirs.
                if (use.database().functions.empty()) return;
                for (const scene::Image& image : use.database().images) {
                  if (std::ranges::find(use.images(), &image, &Use<scene::Image>::record) == use.images().end())
                    requests.add("an image", image.said_at, {});
                }
              },
          .leave_out = without_images};
}

}  // namespace isl::render
