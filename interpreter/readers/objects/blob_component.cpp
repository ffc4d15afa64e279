#include "interpreter/readers/objects/blob_component.h"

#include "interpreter/expressions.h"
#include "interpreter/readers/objects/solid_draft.h"
#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>

namespace isl::interpreter {
namespace {

using scene::Component;
using scene::Skeleton;
using scene::Vec3;
namespace word = grammar::word;

/// A component that is being read.
struct Reading {
  ElementStream& stream;
  Component& c;
  scene::Blob& blob;  ///< takes what the record has no room for
  SourceSpan span;    ///< of the component's block
  bool is_povrays;    ///< no kernel is in force
  bool is_convolved;

  Vec3 point(const char* what) const { return with_comma(read_vector(stream, what)); }
  Vec3 normal(const char* what) const { return with_comma(read_normal(stream, what)); }
  double number(const char* what) const { return with_comma(read_number(stream, what)); }
  double positive(const char* what) const { return with_comma(read_positive(stream, what)); }
  double not_negative(const char* what) const {
    const SourceSpan place = stream.peek().span;
    const double value = read_number(stream, what);
    if (!(value >= 0 && std::isfinite(value)))
      stream.context().fail(place, fmt::format("{} must not be below 0, found {:g}", what, value));
    return with_comma(value);
  }
  /// The radius about the skeleton, which comes last.
  void radius(const char* what) const {
    c.radius_a = c.radius_b = is_povrays ? read_support_radius(stream) : read_positive(stream, what);
  }

  // ---- Geometry that has collapsed: generated models hold some, and its limit has a field as good as any ------------

  /// The component has shrunk to a point. As a segment without a length, its convolution is zero.
  void collapse_to(const Vec3& point, std::string_view found) const {
    c.skeleton = is_convolved ? Skeleton::segment : Skeleton::point;
    c.a = point;
    c.b = is_convolved ? point : Vec3(0);
    warn_collapsed(found, "a point");
  }
  /// Warns if the ends are the same point. Any other segment has a field and a convolution, however short it is.
  void check_ends() const {
    if (c.a == c.b) warn_collapsed("both ends are the same point", "a point");
  }
  void warn_collapsed(std::string_view found, std::string_view left) const {
    stream.context().warn(span, is_convolved
                                    ? fmt::format("{}, so that the convolution of this `{}` is zero", found, word())
                                    : fmt::format("{}, so that this `{}` has the field of {}", found, word(), left));
  }

 private:
  [[nodiscard]] std::string_view word() const { return stream.context().text(stream.word()); }

  template <class Value>
  Value with_comma(const Value& value) const {
    stream.accept_comma();
    return value;
  }
};

void read_sphere_skeleton(const Reading& r) {
  r.c.a = r.point("a point");
  r.radius("a radius");
}

void read_cylinder_skeleton(const Reading& r) {
  r.c.skeleton = Skeleton::segment;
  r.c.a = r.point("a point");
  r.c.b = r.point("the second end");
  r.radius("a radius");
  r.check_ends();
}

void read_cone_skeleton(const Reading& r) {
  r.c.skeleton = Skeleton::cone;
  r.c.a = r.point("a point");
  r.c.radius_a = r.positive("the radius at the first end");
  r.c.b = r.point("the second end");
  r.c.radius_b = read_positive(r.stream, "the radius at the second end");
  r.check_ends();
}

void read_box_skeleton(const Reading& r) {
  r.c.skeleton = Skeleton::box;
  const Vec3 p = r.point("a corner of the box"), q = r.point("the opposite corner of the box");
  for (int i = 0; i < 3; ++i) {
    r.c.a[i] = std::min(p[i], q[i]);
    r.c.b[i] = std::max(p[i], q[i]);
  }
  r.radius("a radius around the box");
}

/// About the y axis, as POV-Ray's torus.
void read_torus_skeleton(const Reading& r) {
  r.c.skeleton = Skeleton::circle;
  r.c.b = Vec3(0, 1, 0);
  r.c.radius_b = r.not_negative("the major radius of the torus");
  r.c.radius_a = read_positive(r.stream, "the minor radius of the torus");
  if (r.c.radius_b == 0) return r.collapse_to(r.c.a, "the major radius is 0");
  if (r.c.radius_a < r.c.radius_b || r.is_convolved) return;
  r.stream.context().warn(r.span, "this torus crosses its own axis, where its field has a crease",
                          "keep the minor radius below the major one, or write `convolution on`, which has no crease");
}

/// Centre and normal come first, as in POV-Ray's disc; the normal is normalised.
void read_disc_skeleton(const Reading& r) {
  r.c.skeleton = Skeleton::disc;
  r.c.a = r.point("the centre of the disc");
  r.c.b = r.normal("the normal of the disc");
  r.c.radius_b = r.not_negative("the radius of the disc");
  r.c.radius_a = read_positive(r.stream, "a radius about the disc");
  if (r.c.radius_b == 0) r.collapse_to(r.c.a, "the radius of the disc is 0");
}

/// Replaces a triangle that is flat to rounding by its longest edge, or by a point. No point of the triangle is farther
/// from that edge than its height, so the height is the error of the distance: at most 2⁻⁴⁸ of the edge's length, 32
/// roundings of the corners. A triangle that is left has a normal: the error of the cross product of the two shorter
/// edges' directions, some 3 roundings, is below a tenth of the sine of the angle between them.
bool collapse_flat(const Reading& r, const std::array<Vec3, 3>& corners) {
  std::array<Vec3, 3> edges;  // edge i goes from corner i to the next
  for (std::size_t i = 0; i < 3; ++i) edges[i] = corners[(i + 1) % 3] - corners[i];
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (edges[i].length() > edges[longest].length()) longest = i;
  }
  const double length = edges[longest].length();
  if (length == 0) {
    r.collapse_to(corners[0], "all corners are the same point");
    return true;
  }
  // Divided by the length, so that their product neither overflows nor vanishes.
  const Vec3 second = edges[(longest + 1) % 3] / length, third = edges[(longest + 2) % 3] / length;
  if (second.cross(third).length() > 0x1p-48) return false;
  r.c.skeleton = Skeleton::segment;
  r.c.a = corners[longest];
  r.c.b = corners[(longest + 1) % 3];
  r.warn_collapsed("the corners lie on one line", "its longest edge");
  return true;
}

void read_triangle_skeleton(const Reading& r) {
  r.c.skeleton = Skeleton::triangle;
  r.c.a = r.point("a corner of the triangle");
  r.c.b = r.point("the second corner");
  const Vec3 third = r.point("the third corner");
  r.radius("a radius around the triangle");
  if (collapse_flat(r, {r.c.a, r.c.b, third})) return;
  r.c.corner = static_cast<std::uint32_t>(r.blob.corners.size());
  r.blob.corners.push_back(third);
}

/// As in POV-Ray's plane the normal is normalised, and the distance is not scaled with it. Of a half-space there is no
/// convolution: the plane itself is the skeleton then.
void read_plane_skeleton(const Reading& r) {
  r.c.skeleton = r.is_convolved ? Skeleton::sheet : Skeleton::plane;
  r.c.b = r.normal("the normal of the plane");
  r.c.a = r.c.b * r.number("the distance of the plane from the origin");
  r.radius("a radius before the plane");
}

struct Row {
  grammar::Symbol word;
  bool needs_kernel, has_convolution;
  void (*read)(const Reading&);
};

constexpr Row kRows[] = {
    {word::kw_sphere, false, false, read_sphere_skeleton},    {word::kw_cylinder, false, true, read_cylinder_skeleton},
    {word::kw_cone, true, false, read_cone_skeleton},         {word::kw_box, true, false, read_box_skeleton},
    {word::kw_torus, true, true, read_torus_skeleton},        {word::kw_disc, true, false, read_disc_skeleton},
    {word::kw_triangle, true, false, read_triangle_skeleton}, {word::kw_plane, true, true, read_plane_skeleton},
};

constexpr auto kComponentWords = [] {
  std::array<grammar::Symbol, std::size(kRows)> words{};
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = kRows[i].word;
  return words;
}();

/// Only skeletons with a closed form are convolved.
void check_convolution(Context& context, const Element& block, const Row& row, const scene::Kernel& kernel) {
  constexpr const char* kHint =
      "a `cylinder`, a `torus` or a `plane` can be convolved, with the kernel \"quartic\" or "
      "\"cauchy\"; `convolution off` turns it off";
  if (!row.has_convolution)
    context.fail(block.word_span, fmt::format("a `{}` has no convolution", context.text(block.word)), kHint);
  if (kernel.shape != scene::KernelShape::quartic && kernel.shape != scene::KernelShape::cauchy) {
    context.fail(block.word_span,
                 fmt::format("the kernel \"{}\" has no convolution",
                             scene::kKernelWords[static_cast<std::size_t>(kernel.shape)]),
                 kHint);
  }
}

}  // namespace

bool is_component_word(grammar::Symbol word) {
  return std::ranges::find(kComponentWords, word) != kComponentWords.end();
}

std::span<const grammar::Symbol> component_words() { return kComponentWords; }

double read_support_radius(ElementStream& stream) {
  const SourceSpan span = stream.peek().span;
  const double radius = read_radius(stream, "a radius");
  if (radius == 0) stream.context().warn(span, "a component of radius 0 has no field; it is left out");
  return radius;
}

Component read_component_shape(ElementStream& stream, const Element& block, const scene::Kernel* kernel,
                               scene::Blob& blob) {
  const Row& row = *std::ranges::find(kRows, block.word, &Row::word);
  Context& context = stream.context();
  if (row.needs_kernel && !kernel) {
    context.fail(block.word_span, fmt::format("a `{}` in a blob needs a kernel in force", context.text(block.word)),
                 "write `kernel \"gaussian\"` before it");
  }
  const bool is_convolved = kernel && kernel->mode == scene::FieldMode::convolution;
  if (is_convolved) check_convolution(context, block, row, *kernel);
  Component component;
  row.read({stream, component, blob, block.span, kernel == nullptr, is_convolved});
  return component;
}

}  // namespace isl::interpreter
