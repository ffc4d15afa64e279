#include "interpreter/readers/words/transform.h"

#include "interpreter/expressions.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/transforms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace isl::interpreter {
namespace {

using grammar::as;
using scene::Transform;
using scene::Vec3;
namespace word = grammar::word;

/// Errors of places, relative to the object's size, that are worth a warning: a millionth is seen in a close view.
constexpr double kLostDigits = 0x1p-20;

/// True if places in the object are uncertain by more than kLostDigits. Below the first condition number, some
/// roundings of 2⁻⁵³ cannot do that, and nothing needs to be computed.
bool loses_digits(const Transform& transform) {
  constexpr double kHarmless = 0x1p30;
  return condition_of(transform) > kHarmless && inverse_error(transform) > kLostDigits;
}

void warn_of_lost_digits(Context& context, SourceSpan span, const Transform& transform, std::string hint = {}) {
  const double digits = std::max(0.0, std::floor(-std::log10(inverse_error(transform))));
  std::string message =
      fmt::format("the transform's condition is {:.0e}: positions in the object are certain to about {:.0f} {}",
                  condition_of(transform), digits, digits == 1 ? "digit" : "digits");
  context.warn(span, std::move(message), std::move(hint));
}

Transform checked(Context& context, const scene::Matrix& matrix, SourceSpan span) {
  Transform transform{matrix, {}};
  double condition = 0;
  if (!invert(matrix, transform.inverse, condition))
    context.fail(span, "this transform is singular: it has no inverse");
  if (loses_digits(transform)) warn_of_lost_digits(context, span, transform);
  return transform;
}

Transform read_scale(ElementStream& stream) {
  const SourceSpan span = stream.peek().span;
  Vec3 factors = read_vector(stream, "a vector or number after `scale`");
  for (int i = 0; i < 3; ++i) {
    if (factors[i] != 0) continue;
    stream.context().warn(span, "a scale of zero is replaced by one");
    factors[i] = 1;
  }
  const Vec3 size(std::abs(factors.x), std::abs(factors.y), std::abs(factors.z));
  const double smallest = std::min({size.x, size.y, size.z});
  const double largest = std::max({size.x, size.y, size.z});
  if (!std::isfinite(1 / smallest) || !std::isfinite(largest)) {
    stream.context().fail_not_finite(
        span, fmt::format("a scale of {:g} has no inverse", std::isfinite(largest) ? smallest : largest));
  }
  return scaling(factors);
}

/// `matrix <m00, m01, m02, m10, …, m32>`: the images of x, y, z, and the offset.
Transform read_matrix(ElementStream& stream) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (!next.is(ElementKind::value) || next.node->kind != grammar::NodeKind::vector) {
    fail_expected(stream, "`<` with the 12 numbers of `matrix`");
  }
  stream.drop();
  const std::vector<double> m = evaluate_coordinates(context, as<grammar::Vector>(*next.node));
  if (m.size() != 12) context.fail(next.span, fmt::format("`matrix` takes 12 numbers, found {}", m.size()));
  if (!std::ranges::all_of(m, [](double entry) { return std::isfinite(entry); }))
    context.fail_not_finite(next.span, "the numbers of `matrix` must be finite");
  scene::Matrix matrix(m[0], m[1], m[2], 0, m[3], m[4], m[5], 0, m[6], m[7], m[8], 0, m[9], m[10], m[11], 1);
  for (int axis = 0; axis < 3; ++axis) {
    if (matrix[axis][0] != 0 || matrix[axis][1] != 0 || matrix[axis][2] != 0) continue;
    context.warn(next.span, fmt::format("this `matrix` scales {} by zero; one is taken", "xyz"[axis]));
    matrix[axis][axis] = 1;
  }
  return checked(context, matrix, next.span);
}

Transform read_named(ElementStream& stream) {
  if (!stream.peek().is(ElementKind::value)) fail_expected(stream, "a transform");
  const SourceSpan span = stream.peek().span;
  const Value value = stream.take_value();
  if (value.kind() != ValueKind::transform)
    stream.context().fail(span, fmt::format("expected a transform, found {}", describe(value)));
  return value.as<TransformValue>().transform;
}

}  // namespace

std::optional<Transform> read_transform(ElementStream& stream) {
  const Element& next = stream.peek();
  if (next.is(ElementKind::word)) {
    switch (static_cast<word::Index>(next.word)) {
      case word::kIndex_translate: stream.drop(); return translation(read_vector(stream, "a vector after `translate`"));
      case word::kIndex_rotate: stream.drop(); return rotation(read_vector(stream, "a vector after `rotate`"));
      case word::kIndex_scale: stream.drop(); return read_scale(stream);
      case word::kIndex_matrix: stream.drop(); return read_matrix(stream);
      case word::kIndex_transform: stream.drop(); return read_named(stream);
      default: return std::nullopt;
    }
  }
  if (!next.is_block(word::kw_transform)) return std::nullopt;
  const Element block = stream.take();
  return read_transform_block(stream.context(), block);
}

Transform then_placed(Context& context, SourceSpan span, const Transform& first, const Transform& next) {
  const Transform total = scene::then(first, next);
  if (loses_digits(total) && !loses_digits(first) && !loses_digits(next)) {
    warn_of_lost_digits(context, span, total, "uneven scales lose nothing as the last transform");
  }
  return total;
}

Transform read_transform_block(Context& context, const Element& block) {
  ElementStream stream(context, block);
  Transform total;
  bool is_inverse = false;
  while (!stream.peek().is(ElementKind::end)) {
    if (stream.peek().is(ElementKind::value)) {
      total = scene::then(total, read_named(stream));
    } else if (stream.peek().is_word(word::kw_inverse)) {
      stream.drop();
      is_inverse = true;
    } else if (const std::optional<Transform> next = read_transform(stream)) {
      total = scene::then(total, *next);
    } else {
      static constexpr grammar::Symbol kKnown[] = {word::kw_translate, word::kw_rotate, word::kw_scale, word::kw_matrix,
                                                   word::kw_inverse};
      refuse(stream, kKnown);
    }
  }
  return is_inverse ? total.inverted() : total;
}

}  // namespace isl::interpreter
