#include "renderer/effects/plan.h"

#include <algorithm>

namespace isl::render {
namespace {

constexpr int kLightingFromQuality = 2;
constexpr int kShadowsFromQuality = 4;

bool shines(const scene::Light& light) {
  return light.colour.red != 0 || light.colour.green != 0 || light.colour.blue != 0;
}

bool can_throw_shadow(const scene::Database& database, const scene::Object& object) {
  if (object.no_shadow) return false;
  if (object.kind != scene::Object::Kind::group) return true;
  const std::vector<scene::Object>& children = database.groups[object.shape].children;
  return std::any_of(children.begin(), children.end(),
                     [&](const scene::Object& child) { return can_throw_shadow(database, child); });
}

bool has_highlight(const scene::Database& database, const scene::Texture& texture) {
  const scene::Finish finish = database.finish(texture.finish);
  return finish.phong > 0 || finish.specular > 0;
}

/// Collects the verdicts, so that every effect is in exactly one of the plan's lists.
class PlanBuilder {
 public:
  bool call_for(const char* name, const char* reason, OriginId origin) {
    plan_.called_for.push_back({name, reason, origin});
    return true;
  }
  bool leave_out(const char* name, const char* reason) {
    plan_.left_out.push_back({name, reason, {}});
    return false;
  }

  Plan plan_;
};

bool plan_lighting(PlanBuilder& builder, const scene::Database& database, int quality) {
  if (quality < kLightingFromQuality) return builder.leave_out("lighting", "the quality asked for shows plain colours");
  for (const scene::Light& light : database.lights) {
    if (shines(light)) return builder.call_for("lighting", "a light shines", light.origin);
  }
  return builder.leave_out("lighting", "no light shines");
}

bool plan_shadows(PlanBuilder& builder, const scene::Database& database, int quality) {
  if (quality < kShadowsFromQuality) return builder.leave_out("shadows", "the quality asked for has no shadows");
  const bool occluder = std::any_of(database.objects.begin(), database.objects.end(),
                                    [&](const scene::Object& object) { return can_throw_shadow(database, object); });
  if (!occluder) return builder.leave_out("shadows", "no object throws a shadow");
  for (const scene::Light& light : database.lights) {
    if (shines(light) && !light.shadowless) {
      return builder.call_for("shadows", "a light that throws shadows, and objects that can stand in its way",
                              light.origin);
    }
  }
  return builder.leave_out("shadows", "no light throws shadows");
}

bool plan_highlights(PlanBuilder& builder, const scene::Database& database, bool lighting) {
  if (!lighting) return builder.leave_out("highlights", "there is no lighting");
  const bool shiny = has_highlight(database, database.default_texture) ||
                     std::any_of(database.textures.begin(), database.textures.end(),
                                 [&](const scene::Texture& texture) { return has_highlight(database, texture); });
  if (!shiny) return builder.leave_out("highlights", "no finish has phong or specular");
  for (const scene::Light& light : database.lights) {
    if (shines(light) && !light.shadowless) {
      return builder.call_for("highlights", "a finish with phong or specular, and a light that is not shadowless",
                              light.origin);
    }
  }
  return builder.leave_out("highlights", "every light is shadowless");
}

}  // namespace

Plan plan_of(const scene::Database& database, int quality) {
  PlanBuilder builder;
  const bool lighting = plan_lighting(builder, database, quality);
  const bool shadows = plan_shadows(builder, database, quality);
  const bool highlights = plan_highlights(builder, database, lighting);
  Plan plan = std::move(builder.plan_);
  plan.plain_colours = quality < kLightingFromQuality;
  plan.lighting = lighting;
  plan.shadows = shadows;
  plan.highlights = highlights;
  return plan;
}

}  // namespace isl::render
