// Mirrors with an `exponent`: the light that they mirror is raised to the power 1/exponent before it is tinted. The
// stage of reflections (reflection.cpp) and paths/bent_light.h do so; this record tells when there is one.
#include "renderer/effects/requests.h"

namespace isl::render {
namespace {

bool has_exponent(const scene::Finish& finish) { return reflects(finish) && finish.reflection.exponent != 1; }

}  // namespace

Effect reflection_exponent() {
  return {.name = "reflection_exponent",
          .summary = "an exponent for the reflected light",
          .from_quality = 8,
          .find = find_finishes("`exponent` of a reflection", scene::FinishItem::exponent, has_exponent),
          .leave_out = [](scene::Database& database) {
            for (scene::Finish& finish : database.finishes) finish.reflection.exponent = 1;
          }};
}

}  // namespace isl::render
