#include "interpreter/readers/objects/blob_component.h"

#include "interpreter/expressions.h"
#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace isl::interpreter {
namespace {

using scene::Component;
using scene::Skeleton;
using scene::Vec3;
namespace word = grammar::word;

void check_apart(ElementStream& stream, const Vec3& a, const Vec3& b) {
  if ((b - a).length() < kTolerance)
    stream.context().fail(stream.span(), "both ends of the component are the same point");
}

void read_sphere(ElementStream& stream, Component& c, scene::Blob&) {
  c.a = read_vector(stream, "a point");
  stream.accept_comma();
  c.radius_a = c.radius_b = read_positive(stream, "a radius");
}

void read_cylinder(ElementStream& stream, Component& c, scene::Blob&) {
  c.skeleton = Skeleton::segment;
  c.a = read_vector(stream, "a point");
  stream.accept_comma();
  c.b = read_vector(stream, "the second end");
  stream.accept_comma();
  c.radius_a = c.radius_b = read_positive(stream, "a radius");
}

void read_cone(ElementStream& stream, Component& c, scene::Blob&) {
  c.skeleton = Skeleton::cone;
  c.a = read_vector(stream, "a point");
  stream.accept_comma();
  c.radius_a = read_positive(stream, "the radius at the first end");
  stream.accept_comma();
  c.b = read_vector(stream, "the second end");
  stream.accept_comma();
  c.radius_b = read_positive(stream, "the radius at the second end");
}

void read_box(ElementStream& stream, Component& c, scene::Blob&) {
  c.skeleton = Skeleton::box;
  const Vec3 p = read_vector(stream, "a corner of the box");
  stream.accept_comma();
  const Vec3 q = read_vector(stream, "the opposite corner of the box");
  stream.accept_comma();
  for (int i = 0; i < 3; ++i) {
    c.a[i] = std::min(p[i], q[i]);
    c.b[i] = std::max(p[i], q[i]);
  }
  c.radius_a = c.radius_b = read_positive(stream, "a radius around the box");
}

/// About the y axis, as POV-Ray's torus.
void read_torus(ElementStream& stream, Component& c, scene::Blob&) {
  c.skeleton = Skeleton::circle;
  c.b = Vec3(0, 1, 0);
  c.radius_b = read_positive(stream, "the major radius of the torus");
  stream.accept_comma();
  c.radius_a = read_positive(stream, "the minor radius of the torus");
}

void read_triangle(ElementStream& stream, Component& c, scene::Blob& blob) {
  c.skeleton = Skeleton::triangle;
  c.a = read_vector(stream, "a corner of the triangle");
  stream.accept_comma();
  c.b = read_vector(stream, "the second corner");
  stream.accept_comma();
  const Vec3 third = read_vector(stream, "the third corner");
  stream.accept_comma();
  c.radius_a = c.radius_b = read_positive(stream, "a radius around the triangle");
  // The sine of the angle at the first corner; rounding alone makes some 1e-16 of it.
  const Vec3 ab = c.b - c.a, ac = third - c.a;
  if (!(ab.cross(ac).length() > kTolerance * ab.length() * ac.length()) || !(ab.length() > 0 && ac.length() > 0)) {
    stream.context().fail(stream.span(), "the corners of the triangle lie on one line",
                          "use a `cylinder` for the segment between two points");
  }
  c.corner = static_cast<std::uint32_t>(blob.corners.size());
  blob.corners.push_back(third);
}

/// As in POV-Ray's plane the normal is normalised, and the distance is not scaled with it.
void read_plane(ElementStream& stream, Component& c, scene::Blob&) {
  c.skeleton = Skeleton::plane;
  c.b = read_normal(stream, "the normal of the plane");
  stream.accept_comma();
  const double distance = read_number(stream, "the distance of the plane from the origin");
  stream.accept_comma();
  c.radius_a = c.radius_b = read_positive(stream, "a radius before the plane");
  c.a = c.b * distance;
}

struct Row {
  grammar::Symbol word;
  bool needs_kernel, has_convolution;
  void (*read)(ElementStream&, Component&, scene::Blob&);
};

constexpr Row kRows[] = {
    {word::kw_sphere, false, false, read_sphere}, {word::kw_cylinder, false, true, read_cylinder},
    {word::kw_cone, true, false, read_cone},      {word::kw_box, true, false, read_box},
    {word::kw_torus, true, true, read_torus},     {word::kw_triangle, true, false, read_triangle},
    {word::kw_plane, true, true, read_plane},
};

constexpr auto kWords = [] {
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

bool is_component_word(grammar::Symbol word) { return std::ranges::find(kWords, word) != kWords.end(); }

std::span<const grammar::Symbol> component_words() { return kWords; }

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
  row.read(stream, component, blob);
  // A half-space has no convolution: the plane itself is the skeleton.
  if (is_convolved && component.skeleton == Skeleton::plane) component.skeleton = Skeleton::sheet;
  const bool crosses_axis = component.skeleton == Skeleton::circle && component.radius_a >= component.radius_b;
  if (crosses_axis && !is_convolved) {
    context.warn(block.span, "this torus crosses its own axis, where its field has a crease",
                 "keep the minor radius below the major one, or write `convolution on`, which has no crease");
  }
  // A segment of any length has a convolution, which depends on its length.
  const bool has_ends = component.skeleton == Skeleton::segment || component.skeleton == Skeleton::cone;
  if (has_ends && !is_convolved) check_apart(stream, component.a, component.b);
  return component;
}

}  // namespace isl::interpreter
