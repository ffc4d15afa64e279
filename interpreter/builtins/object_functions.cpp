// Functions that ask about objects: trace, inside, min_extent, max_extent. Another module answers
// (renderer/scene/queries.h).
#include "interpreter/builtins/builtins.h"

#include "renderer/scene/queries.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;
using scene::Vec3;

/// POV-Ray's extent of an infinite side, and of an object without a surface.
constexpr double kFarthest = 1e10;

scene::Queries& queries(const Arguments& a) {
  if (!a.context().options.queries) a.context().fail(a.span(), "properties of objects are not available here");
  return *a.context().options.queries;
}

/// The object of argument 0, as it would be placed in the world.
const scene::Object& object(const Arguments& a) {
  if (a[0].kind() != ValueKind::object) a.fail(0, fmt::format("expected an object, found {}", describe(a[0])));
  const scene::Object& object = a[0].as<ObjectValue>().object;
  if (object.shape == scene::kNone) a.fail(0, "a light has no surface");
  return object;
}

/// Ends the evaluation if the last question has no answer.
void check_answer(const Arguments& a) {
  a.context().check_stop(a.span());
  const std::optional<scene::Refusal> refusal = queries(a).refusal();
  if (refusal) a.context().stop(a.span(), refusal->message, refusal->hint);
}

Value trace(const Arguments& a) {
  Context& context = a.context();
  const scene::Object& target = object(a);
  const Vec3 origin = a.vector(1), direction = a.vector(2);
  Slot* const normal = a.size() >= 4 ? &a.variable(3) : nullptr;
  if (normal && normal->value.term_count() != 3) {
    a.fail(3,
           fmt::format("expected a variable with a 3-term vector for the normal, found {}", describe(normal->value)));
  }
  Slot* const certain = a.size() == 5 ? &a.variable(4) : nullptr;
  if (certain && certain->value.term_count() != 1) {
    a.fail(4, fmt::format("expected a variable with a number for the certainty, found {}", describe(certain->value)));
  }
  const auto [hit, is_certain] = queries(a).trace(context.database, target, origin, direction);
  check_answer(a);
  if (normal) normal->value = to_value(hit ? hit->normal : Vec3(0));
  if (certain) certain->value = Value(is_certain ? 1.0 : 0.0);
  return to_value(hit ? hit->position : Vec3(0));
}

Value inside(const Arguments& a) {
  const scene::Object& target = object(a);
  const bool is_in = queries(a).inside(a.context().database, target, a.vector(1));
  check_answer(a);
  return Value(is_in ? 1.0 : 0.0);
}

/// A corner of the box; `sign` is −1 for the least.
Value corner(const Arguments& a, double sign) {
  const scene::Object& target = object(a);
  const Imath::Box3d box = queries(a).extent(a.context().database, target);
  if (box.isEmpty()) return to_value(Vec3(sign * kFarthest));
  Vec3 result = sign < 0 ? box.min : box.max;
  for (int i = 0; i < 3; ++i) result[i] = std::clamp(result[i], -kFarthest, kFarthest);
  return to_value(result);
}

const Builtin kObjectFunctions[] = {
    {word::kw_trace, 3, 5, nullptr, trace},
    {word::kw_inside, 2, 2, nullptr, inside},
    {word::kw_min_extent, 1, 1, nullptr, [](const Arguments& a) { return corner(a, -1); }},
    {word::kw_max_extent, 1, 1, nullptr, [](const Arguments& a) { return corner(a, 1); }},
};

}  // namespace

std::span<const Builtin> object_functions() { return kObjectFunctions; }

}  // namespace isl::interpreter
