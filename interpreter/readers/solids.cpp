// The ordinary solids: sphere, cylinder, cone, plane.
#include "interpreter/expressions.h"
#include "interpreter/readers/arguments.h"
#include "interpreter/readers/objects.h"

#include <fmt/format.h>

#include <cmath>

namespace isl::interpreter {
namespace {

using scene::Solid;
using scene::SolidKind;
using scene::Vec3;
namespace word = grammar::word;

void add(ElementStream& stream, ObjectDraft& draft, const Solid& solid) {
  Context& context = stream.context();
  context.count_primitive(stream.span(), sizeof(Solid) + sizeof(scene::Object) + kOriginBytes);
  draft.object.kind = scene::Object::Kind::solid;
  draft.object.shape = static_cast<std::uint32_t>(context.database.solids.size());
  context.database.solids.push_back(solid);
}

/// The first vector of the geometry, or true after copying the object that stands in its place.
bool read_copy_or_vector(ElementStream& stream, ObjectDraft& draft, std::string_view what, Vec3& vector) {
  if (!stream.peek().is(ElementKind::value)) fail_expected(stream, what);
  const SourceSpan span = stream.peek().span;
  const Value value = stream.take_value();
  if (value.kind() == ValueKind::object) {
    copy_object(stream, value.as<ObjectValue>(), draft);
    return true;
  }
  vector = to_vector(stream, value, span, what);
  return false;
}

/// POV-Ray takes a negative radius for its absolute value.
double read_radius(ElementStream& stream) {
  const SourceSpan span = stream.peek().span;
  const double radius = std::abs(read_number(stream, "a radius"));
  if (!(radius > 0 && std::isfinite(radius)))
    stream.context().fail(span, fmt::format("a radius is above 0, found {:g}", radius));
  return radius;
}

bool read_open(ElementStream& stream) {
  if (!stream.peek().is_word(word::kw_open)) return false;
  stream.drop();
  return true;
}

void check_ends(ElementStream& stream, const Vec3& a, const Vec3& b) {
  if ((b - a).length() < kTolerance) stream.context().fail(stream.span(), "both ends are the same point");
}

}  // namespace

void read_sphere(ElementStream& stream, ObjectDraft& draft) {
  Solid solid{.kind = SolidKind::sphere};
  if (read_copy_or_vector(stream, draft, "the centre of the sphere", solid.a)) return;
  stream.accept_comma();
  solid.radius_a = read_radius(stream);
  add(stream, draft, solid);
}

void read_cylinder(ElementStream& stream, ObjectDraft& draft) {
  Solid solid{.kind = SolidKind::cylinder};
  if (read_copy_or_vector(stream, draft, "the first end of the cylinder", solid.a)) return;
  stream.accept_comma();
  solid.b = read_vector(stream, "the second end of the cylinder");
  stream.accept_comma();
  solid.radius_a = solid.radius_b = read_radius(stream);
  solid.open = read_open(stream);
  check_ends(stream, solid.a, solid.b);
  add(stream, draft, solid);
}

void read_cone(ElementStream& stream, ObjectDraft& draft) {
  Solid solid{.kind = SolidKind::cone};
  if (read_copy_or_vector(stream, draft, "the first end of the cone", solid.a)) return;
  stream.accept_comma();
  solid.radius_a = std::abs(read_number(stream, "the radius at the first end"));
  stream.accept_comma();
  solid.b = read_vector(stream, "the second end of the cone");
  stream.accept_comma();
  solid.radius_b = std::abs(read_number(stream, "the radius at the second end"));
  solid.open = read_open(stream);
  check_ends(stream, solid.a, solid.b);
  if (!(solid.radius_a + solid.radius_b > 0) || !std::isfinite(solid.radius_a + solid.radius_b)) {
    stream.context().fail(stream.span(), "a cone needs a finite radius above 0 at one end");
  }
  add(stream, draft, solid);
}

void read_plane(ElementStream& stream, ObjectDraft& draft) {
  Solid solid{.kind = SolidKind::plane};
  const SourceSpan span = stream.peek().span;
  if (read_copy_or_vector(stream, draft, "the normal of the plane", solid.a)) return;
  stream.accept_comma();
  // The normal is normalised, the distance is not scaled with it.
  solid.radius_a = read_number(stream, "the distance of the plane");
  const double length = solid.a.length();
  if (!(length > 0)) stream.context().fail(span, "the normal of a plane has a length above 0");
  solid.a /= length;
  add(stream, draft, solid);
}

}  // namespace isl::interpreter
