// The solids where a polynomial of x, y and z is not positive: quadric, cubic, quartic, poly.
#include "interpreter/expressions.h"
#include "interpreter/readers/objects/solid_draft.h"
#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isl::interpreter {
namespace {

using scene::Polynomial;
using scene::SolidKind;

/// POV-Ray's range.
constexpr int kMinOrder = 2, kMaxOrder = 35;

void add_polynomial(ElementStream& stream, ObjectDraft& draft, SolidKind kind, Polynomial polynomial) {
  Context& context = stream.context();
  const auto is_zero = [](double c) { return c == 0; };
  if (!std::ranges::all_of(polynomial.coefficients, [](double c) { return std::isfinite(c); }))
    context.fail_not_finite(stream.span(), "the coefficients of a polynomial must be finite");
  // The last coefficient is the constant: if all others are zero, the polynomial has the same value everywhere.
  if (std::all_of(polynomial.coefficients.begin(), polynomial.coefficients.end() - 1, is_zero))
    context.warn(stream.span(), "this polynomial is constant: it has no surface");
  const auto detail = static_cast<std::uint32_t>(context.database.polynomials.size());
  const std::size_t bytes = sizeof(Polynomial) + polynomial.coefficients.size() * sizeof(double);
  context.database.polynomials.push_back(std::move(polynomial));
  add_solid(stream, draft, {.kind = kind, .detail = detail}, bytes);
}

/// `<a, b, …>` with exactly as many numbers as the order has terms.
std::vector<double> read_coefficients(ElementStream& stream, int order) {
  const Element next = stream.peek();
  if (!next.is(ElementKind::value) || next.node->kind != grammar::NodeKind::vector)
    fail_expected(stream, "`<` with the coefficients");
  stream.drop();
  std::vector<double> numbers = evaluate_coordinates(stream.context(), grammar::as<grammar::Vector>(*next.node));
  const std::size_t count = Polynomial::coefficient_count(order);
  if (numbers.size() != count) {
    stream.context().fail(
        next.span, fmt::format("a polynomial of order {} has {} coefficients, found {}", order, count, numbers.size()));
  }
  return numbers;
}

void read_of_order(ElementStream& stream, ObjectDraft& draft, SolidKind kind, int order) {
  if (read_copy(stream, draft)) return;
  add_polynomial(stream, draft, kind, {order, read_coefficients(stream, order)});
}

}  // namespace

void read_quadric(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  const scene::Vec3 squares = read_vector(stream, "the coefficients of x², y², z²");
  stream.accept_comma();
  const scene::Vec3 mixed = read_vector(stream, "the coefficients of xy, xz, yz");
  stream.accept_comma();
  const scene::Vec3 linear = read_vector(stream, "the coefficients of x, y, z");
  stream.accept_comma();
  const double constant = read_number(stream, "the constant of the quadric");
  add_polynomial(
      stream, draft, SolidKind::quadric,
      {2, {squares.x, mixed.x, mixed.y, linear.x, squares.y, mixed.z, linear.y, squares.z, linear.z, constant}});
}

void read_cubic(ElementStream& stream, ObjectDraft& draft) { read_of_order(stream, draft, SolidKind::cubic, 3); }

void read_quartic(ElementStream& stream, ObjectDraft& draft) { read_of_order(stream, draft, SolidKind::quartic, 4); }

void read_poly(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  const int order = static_cast<int>(read_number_in(stream, "the order of a `poly`", kMinOrder, kMaxOrder));
  stream.accept_comma();
  add_polynomial(stream, draft, SolidKind::poly, {order, read_coefficients(stream, order)});
}

}  // namespace isl::interpreter
