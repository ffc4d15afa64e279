// The solids of a few numbers: sphere, cylinder, cone, plane, box, torus, ovus, disc, superellipsoid.
#include "interpreter/expressions.h"
#include "interpreter/readers/objects/solid_draft.h"
#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace isl::interpreter {
namespace {

using scene::Solid;
using scene::SolidKind;
using scene::Vec3;
namespace word = grammar::word;

/// As in POV-Ray, a negative radius is a mistake here.
double read_radius_from_zero(ElementStream& stream, std::string_view what) {
  const SourceSpan span = stream.peek().span;
  const double radius = read_number(stream, what);
  if (!(radius >= 0 && std::isfinite(radius)))
    stream.context().fail(span, fmt::format("{} must be finite and at least 0, found {:g}", what, radius));
  return radius;
}

/// A corner of a box may lie at infinity, as that of a floor may. POV-Ray sees nothing beyond 1e7, where the box ends
/// here.
Vec3 read_corner(ElementStream& stream, std::string_view what) {
  constexpr double kEnd = 1e7;
  const Element next = stream.peek();
  if (!next.is(ElementKind::value)) fail_expected(stream, what);
  const Value value = stream.take_value();
  if (!value.is_numeric()) return to_vector(stream, value, next.span, what);
  Value::Terms terms = value.terms();
  for (double& term : terms) {
    if (!std::isinf(term)) continue;
    stream.context().warn(next.span, fmt::format("an infinite coordinate of a box is taken as {:g}", kEnd));
    term = std::copysign(kEnd, term);
  }
  return to_vector(stream, Value(value.term_count(), terms), next.span, what);
}

void check_ends(ElementStream& stream, const Vec3& a, const Vec3& b) {
  if ((b - a).length() < kTolerance) stream.context().fail(stream.span(), "both ends are the same point");
}

}  // namespace

void read_sphere(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  Solid solid{.kind = SolidKind::sphere};
  solid.a = read_vector(stream, "the centre of the sphere");
  stream.accept_comma();
  solid.radius_a = read_radius(stream, "a radius");
  if (solid.radius_a == 0) return leave_out(stream, draft, "this sphere has the radius 0");
  add_solid(stream, draft, solid);
}

void read_cylinder(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  Solid solid{.kind = SolidKind::cylinder};
  solid.a = read_vector(stream, "the first end of the cylinder");
  stream.accept_comma();
  solid.b = read_vector(stream, "the second end of the cylinder");
  stream.accept_comma();
  solid.radius_a = solid.radius_b = read_radius(stream, "a radius");
  solid.open = read_open(stream);
  check_ends(stream, solid.a, solid.b);
  if (solid.radius_a == 0) return leave_out(stream, draft, "this cylinder has the radius 0");
  add_solid(stream, draft, solid);
}

void read_cone(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  Solid solid{.kind = SolidKind::cone};
  solid.a = read_vector(stream, "the first end of the cone");
  stream.accept_comma();
  solid.radius_a = read_radius(stream, "the radius at the first end");
  stream.accept_comma();
  solid.b = read_vector(stream, "the second end of the cone");
  stream.accept_comma();
  solid.radius_b = read_radius(stream, "the radius at the second end");
  solid.open = read_open(stream);
  check_ends(stream, solid.a, solid.b);
  if (solid.radius_a == 0 && solid.radius_b == 0) return leave_out(stream, draft, "this cone has the radius 0");
  add_solid(stream, draft, solid);
}

void read_plane(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  Solid solid{.kind = SolidKind::plane};
  // The normal is normalised, the distance is not scaled with it.
  solid.a = read_normal(stream, "the normal of the plane");
  stream.accept_comma();
  solid.radius_a = read_number(stream, "the distance of the plane");
  add_solid(stream, draft, solid);
}

void read_box(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  const Vec3 p = read_corner(stream, "a corner of the box");
  stream.accept_comma();
  const Vec3 q = read_corner(stream, "the opposite corner of the box");
  Solid solid{.kind = SolidKind::box};
  for (int i = 0; i < 3; ++i) {
    solid.a[i] = std::min(p[i], q[i]);
    solid.b[i] = std::max(p[i], q[i]);
    if (solid.a[i] == solid.b[i]) {
      stream.context().warn(stream.span(), fmt::format("this box has no thickness along {}", "xyz"[i]));
    }
  }
  add_solid(stream, draft, solid);
}

namespace {

/// The words that say which parts of a spindle torus count, as POV-Ray 3.8 has them: all of it; all surfaces, its own
/// within too, as without a word; all but the spindle; the spindle alone.
constexpr grammar::Symbol kSpindleWords[] = {word::kw_merge, word::kw_union, word::kw_difference,
                                             word::kw_intersection};

std::optional<grammar::Symbol> accept_spindle_word(ElementStream& stream) {
  const Element next = stream.peek();
  if (!next.is(ElementKind::word) || std::ranges::find(kSpindleWords, next.word) == std::end(kSpindleWords)) return {};
  stream.drop();
  return next.word;
}

/// A solid as a child of a group.
scene::Object child_of(Context& context, const ObjectDraft& draft, const Solid& solid) {
  scene::Object child;
  child.kind = scene::Object::Kind::solid;
  child.shape = static_cast<std::uint32_t>(context.database.solids.size());
  child.origin = draft.object.origin;
  context.database.solids.push_back(solid);
  return child;
}

void add_spindle_torus(ElementStream& stream, ObjectDraft& draft, const Solid& whole, grammar::Symbol part) {
  // The spindle is the torus of the opposite major radius (renderer/solids/torus.cpp).
  Solid spindle = whole;
  spindle.radius_a = -whole.radius_a;
  if (part == word::kw_merge) return add_solid(stream, draft, whole);
  if (part == word::kw_intersection) return add_solid(stream, draft, spindle);
  Context& context = stream.context();
  context.count_primitive(stream.span(), 2 * (sizeof(Solid) + sizeof(scene::Object)) + kOriginBytes);
  scene::Group group{.operation = part == word::kw_union ? scene::Operation::unite : scene::Operation::subtract};
  group.children.push_back(child_of(context, draft, whole));
  group.children.push_back(child_of(context, draft, spindle));
  set_group(stream, draft, std::move(group));
}

}  // namespace

void read_torus(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  Solid solid{.kind = SolidKind::torus};
  solid.radius_a = read_radius(stream, "the major radius of the torus");
  stream.accept_comma();
  solid.radius_b = read_radius(stream, "the minor radius of the torus");
  if (solid.radius_b == 0) return leave_out(stream, draft, "this torus has the minor radius 0");
  const grammar::Symbol part = accept_spindle_word(stream).value_or(word::kw_union);
  const bool has_spindle = solid.radius_b > solid.radius_a;
  if (has_spindle && solid.radius_a > 0) return add_spindle_torus(stream, draft, solid, part);
  add_solid(stream, draft, solid);
}

namespace {

/// Since 3.8: `radius` of the arcs, `distance` of the two centres, and `precision` of a search that is exact here.
void read_ovus_controls(ElementStream& stream, Solid& solid) {
  Context& context = stream.context();
  const double bottom = solid.radius_a, top = solid.radius_b;
  SourceSpan radius_span, distance_span;
  for (;;) {
    const Element next = stream.peek();
    const bool is_radius = next.is_word(word::kw_radius), is_distance = next.is_word(word::kw_distance);
    if (!is_radius && !is_distance && !next.is_word(word::kw_precision)) break;
    stream.drop();
    const SourceSpan span = stream.peek().span;
    const double number = read_number(stream, fmt::format("a number after `{}`", context.text(next.word)));
    if (is_radius) {
      solid.a.y = number;
      radius_span = span;
    } else if (is_distance) {
      solid.a.x = number;
      distance_span = span;
    }
  }
  if (!distance_span.empty() && !(solid.a.x >= bottom && std::isfinite(solid.a.x)))
    context.fail(distance_span,
                 fmt::format("the `distance` of an ovus must be at least its bottom radius of {:g}, found {:g}", bottom,
                             solid.a.x));
  const double least = (bottom + top + std::max(solid.a.x, bottom)) / 2;
  if (!radius_span.empty() && !(solid.a.y >= least && std::isfinite(solid.a.y)))
    context.fail(
        radius_span,
        fmt::format("the `radius` of an ovus must be at least half of its height, {:g}, found {:g}", least, solid.a.y));
}

}  // namespace

void read_ovus(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  Solid solid{.kind = SolidKind::ovus};
  solid.radius_a = read_radius_from_zero(stream, "the bottom radius of an ovus");
  stream.accept_comma();
  solid.radius_b = read_radius_from_zero(stream, "the top radius of an ovus");
  read_ovus_controls(stream, solid);
  const double bottom = solid.radius_a, top = solid.radius_b;
  const double distance = solid.a.x > 0 ? solid.a.x : bottom;
  if (bottom == 0 && top == 0) return leave_out(stream, draft, "this ovus has the radius 0");
  if (top >= bottom + distance) {  // its sphere would hold all the rest
    stream.context().warn(stream.span(),
                          fmt::format("this ovus has a top radius of {:g}, which is not below {} of {:g}; it becomes a "
                                      "sphere",
                                      top, solid.a.x > 0 ? "its bottom radius and distance" : "twice its bottom radius",
                                      solid.a.x > 0 ? bottom + distance : bottom));
    solid = {.kind = SolidKind::sphere, .a = {0, distance, 0}, .radius_a = top};
  } else if (solid.a.y == bottom) {  // then the top is a point of the bottom sphere
    solid = {.kind = SolidKind::sphere, .radius_a = bottom};
  }
  add_solid(stream, draft, solid);
}

void read_disc(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  Solid solid{.kind = SolidKind::disc};
  solid.a = read_vector(stream, "the centre of the disc");
  stream.accept_comma();
  const Vec3 normal = read_vector(stream, "the normal of the disc");
  stream.accept_comma();
  solid.radius_a = read_radius(stream, "a radius");
  const bool has_hole = stream.accept_comma() || stream.peek().is(ElementKind::value);
  if (has_hole) solid.radius_b = read_radius(stream, "the radius of the hole");
  if (normal == Vec3(0)) return leave_out(stream, draft, "the normal of this disc has no direction");
  solid.b = normal / normal.length();
  if (solid.radius_b >= solid.radius_a) return leave_out(stream, draft, "this disc has a hole as large as itself");
  add_solid(stream, draft, solid);
}

void read_superellipsoid(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  const Element next = stream.peek();
  if (!next.is(ElementKind::value)) fail_expected(stream, "the exponents <e, n> of the superellipsoid");
  const Value value = stream.take_value();
  if (!value.is_numeric())
    stream.context().fail(next.span, fmt::format("expected the exponents <e, n>, found {}", describe(value)));
  Solid solid{.kind = SolidKind::superellipsoid};
  solid.radius_a = value.terms()[0];
  solid.radius_b = value.is_number() ? value.number() : value.terms()[1];
  if (!std::isfinite(solid.radius_a) || !std::isfinite(solid.radius_b)) {
    stream.context().fail_not_finite(
        next.span, fmt::format("the exponents of a superellipsoid must be finite, found <{:g}, {:g}>", solid.radius_a,
                               solid.radius_b));
  }
  if (solid.radius_b < 0) return leave_out(stream, draft, "a superellipsoid with its second exponent below 0 is empty");
  if (solid.radius_a < 0)
    stream.context().warn(next.span, "a superellipsoid with its first exponent below 0 reaches the faces of its cube");
  // Edges are sharp at the exponent 0; here they are rounded by 2⁻¹⁷ of the cube, which no picture shows.
  constexpr double kSharpest = 0x1p-16;
  for (double* exponent : {&solid.radius_a, &solid.radius_b}) {
    if (*exponent == 0) *exponent = kSharpest;
  }
  add_solid(stream, draft, solid);
}

}  // namespace isl::interpreter
