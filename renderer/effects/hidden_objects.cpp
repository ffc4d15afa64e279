// Objects that some rays do not meet. A ray has its purpose (RayKind), and the tracer tests the object's flags. These
// records tell which scenes have such objects.
#include "renderer/effects/effect.h"

namespace isl::render {
namespace {

using scene::Object;

/// The effect of a flag of objects. `what` is the flag as the language writes it.
Effect hiding(std::string_view name, std::string_view summary, std::string_view what, bool Object::*flag,
              scene::ObjectItem item) {
  return {.name = name,
          .summary = summary,
          .find =
              [=](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "no object has this flag";
                for (const Use<Object>& object : use.objects()) {
                  if (object.record->*flag) requests.add(what, object.record->said_at[item], object.user);
                }
              },
          .leave_out =
              [=](scene::Database& database) {
                for (Object& object : database.objects) object.*flag = false;
                for (scene::Group& group : database.groups) {
                  for (Object& child : group.children) child.*flag = false;
                }
              }};
}

}  // namespace

Effect no_image() {
  return hiding("no_image", "objects seen only in reflections and by their shadows", "`no_image`", &Object::no_image,
                scene::ObjectItem::no_image);
}

Effect no_reflection() {
  return hiding("no_reflection", "objects not seen in reflections", "`no_reflection`", &Object::no_reflection,
                scene::ObjectItem::no_reflection);
}

}  // namespace isl::render
