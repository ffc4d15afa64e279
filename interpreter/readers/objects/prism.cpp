// prism: an outline of a spline, swept between two heights. As in POV-Ray, a contour ends where its first point comes
// again, and the next one begins after it, with points of its own that guide its spline.
#include "interpreter/expressions.h"
#include "interpreter/readers/objects/outline_pen.h"
#include "interpreter/readers/objects/solid_draft.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace isl::interpreter {
namespace {

using scene::SolidKind;
namespace word = grammar::word;

/// The points that a prism is given: those of a contour follow one another.
using PrismPoints = std::span<const PlanePoint>;

bool is_same(const PlanePoint& a, const PlanePoint& b) { return std::hypot(a.u - b.u, a.v - b.v) < kTolerance; }

PlanePoint moved(const PlanePoint& from, const PlanePoint& a, const PlanePoint& b, double factor) {
  return {from.u + (b.u - a.u) * factor, from.v + (b.v - a.v) * factor};
}

/// The points that one segment of the spline adds to a contour, in Bézier form, and those of the list that it takes.
struct PrismSpline {
  grammar::Symbol word;
  int least_points;
  std::size_t before, after;  ///< points of a contour that only guide its curve, before its first and after its last
  std::size_t step;           ///< points from one segment's beginning to the next one's
  std::size_t to_end;         ///< points from a segment's beginning to its end
  /// Draws the segment that begins at points[i], with a given end.
  void (*draw)(OutlinePen& pen, PrismPoints points, std::size_t i, const PlanePoint& end);
};

constexpr PrismSpline kPrismSplines[] = {
    {word::kw_linear_spline, 3, 0, 0, 1, 1,
     [](OutlinePen& pen, PrismPoints, std::size_t, const PlanePoint& end) { pen.curve_to({end}); }},
    // From p₁ to p₂ with the slope (p₂ − p₀)/2 at p₁.
    {word::kw_quadratic_spline, 5, 1, 0, 1, 1,
     [](OutlinePen& pen, PrismPoints p, std::size_t i, const PlanePoint& end) {
       pen.curve_to({moved(p[i], p[i - 1], p[i + 1], 0.25), end});
     }},
    // From p₁ to p₂ with the slopes (p₂ − p₀)/2 and (p₃ − p₁)/2 (Catmull and Rom).
    {word::kw_cubic_spline, 6, 1, 1, 1, 1,
     [](OutlinePen& pen, PrismPoints p, std::size_t i, const PlanePoint& end) {
       pen.curve_to({moved(p[i], p[i - 1], p[i + 1], 1.0 / 6), moved(p[i + 1], p[i + 2], p[i], 1.0 / 6), end});
     }},
    {word::kw_bezier_spline, 4, 0, 0, 4, 3,
     [](OutlinePen& pen, PrismPoints p, std::size_t i, const PlanePoint& end) {
       if (!is_same(p[i], pen.end())) pen.curve_to({p[i]});
       pen.curve_to({p[i + 1], p[i + 2], end});
     }},
};

/// Draws the contour that begins with the first of `points`, and returns the number of points that belong to it.
/// `is_closed` tells if its first point came again.
std::size_t draw_contour(const PrismSpline& spline, PrismPoints points, OutlinePen& pen, bool& is_closed) {
  is_closed = false;
  std::size_t i = spline.before;
  if (i >= points.size()) return points.size();
  const PlanePoint first = points[i];
  pen.move_to(first);
  for (; i + spline.to_end + spline.after < points.size(); i += spline.step) {
    is_closed = is_same(points[i + spline.to_end], first);
    spline.draw(pen, points, i, is_closed ? first : points[i + spline.to_end]);
    if (is_closed) return i + spline.to_end + spline.after + 1;
  }
  return points.size();
}

/// A contour that is not closed is closed by a line if it consists of lines; otherwise it is left out, as in POV-Ray.
void draw_prism(ElementStream& stream, const PrismSpline& spline, PrismPoints points, scene::Outline& outline) {
  OutlinePen pen(outline);
  while (!points.empty()) {
    bool is_closed = false;
    points = points.subspan(draw_contour(spline, points, pen, is_closed));
    const bool is_of_lines = spline.word == word::kw_linear_spline;
    if (!is_closed) {
      stream.context().warn(
          stream.span(),
          fmt::format("a contour of this prism is not closed: its first point does not come again; {}",
                      is_of_lines ? "a line from its last point to its first closes it" : "it is left out"));
      if (!is_of_lines) pen.discard();
    }
    pen.close();
  }
}

std::vector<PlanePoint> read_points(ElementStream& stream, const PrismSpline& spline) {
  Context& context = stream.context();
  const SourceSpan span = stream.peek().span;
  const double number = read_number(stream, "the number of points of the prism");
  if (!(number >= spline.least_points))
    context.fail(span, fmt::format("a prism with a `{}` needs at least {} points, found {:g}",
                                   context.text(spline.word), spline.least_points, number));
  const auto count = static_cast<std::size_t>(std::min(number, context.options.limits.max_primitives));
  if (count % spline.step != 0)
    context.fail(span, fmt::format("a prism with a `{}` needs {} points for each curve, found {:g}",
                                   context.text(spline.word), spline.step, number));
  std::vector<PlanePoint> points;
  while (points.size() < count) {
    stream.accept_comma();
    make_room_to_append(context, stream.span(), points);
    const SourceSpan place = stream.peek().span;
    const scene::Vec3 point = read_vector(stream, "a point of the prism");
    if (!std::isfinite(point.x) || !std::isfinite(point.y))
      context.fail_not_finite(place, "a point of a prism must be finite");
    points.push_back({point.x, point.y});
  }
  return points;
}

double read_height(ElementStream& stream) {
  const SourceSpan span = stream.peek().span;
  const double height = read_number(stream, "a height of the prism");
  if (!std::isfinite(height))
    stream.context().fail_not_finite(span, fmt::format("a height must be finite, found {:g}", height));
  stream.accept_comma();
  return height;
}

}  // namespace

void read_prism(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  const PrismSpline* spline = &kPrismSplines[0];
  scene::Outline outline;
  while (stream.peek().is(ElementKind::word)) {
    const grammar::Symbol name = stream.peek().word;
    const auto* const row = std::ranges::find(kPrismSplines, name, &PrismSpline::word);
    if (row != std::end(kPrismSplines)) {
      spline = row;
    } else if (name == word::kw_linear_sweep || name == word::kw_conic_sweep) {
      outline.is_conic = name == word::kw_conic_sweep;
    } else {
      fail_expected(stream, "a kind of spline or sweep, or the first height of the prism");
    }
    stream.drop();
  }
  const double a = read_height(stream), b = read_height(stream);
  const std::vector<PlanePoint> points = read_points(stream, *spline);
  const bool is_open = read_open(stream);
  draw_prism(stream, *spline, points, outline);
  if (a == b) return leave_out(stream, draft, "both heights of this prism are the same");
  if (outline.contours.empty()) return leave_out(stream, draft, "this prism has no contour");
  add_outline(stream, draft,
              {.kind = SolidKind::prism, .open = is_open, .radius_a = std::min(a, b), .radius_b = std::max(a, b)},
              std::move(outline));
}

}  // namespace isl::interpreter
