#include "interpreter/readers/view/focal_blur.h"

#include "interpreter/readers/textures/pigment.h"
#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <cmath>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

/// POV-Ray's sharp distance without a focal_point.
constexpr double kDefaultFocalDistance = 1;

}  // namespace

FocalBlurReader::FocalBlurReader(const std::optional<scene::FocalBlur>& blur) {
  if (blur) blur_ = *blur;
}

bool FocalBlurReader::read(ElementStream& stream) {
  const Element next = stream.peek();
  if (next.is_block(word::kw_bokeh)) {
    stream.drop();
    read_bokeh(stream.context(), next);
    return true;
  }
  if (!next.is(ElementKind::word)) return false;
  switch (static_cast<word::Index>(next.word)) {
    case word::kIndex_aperture:
      stream.drop();
      blur_.aperture = std::abs(read_number(stream, "a number after `aperture`"));
      is_pinhole_ = blur_.aperture == 0;
      return true;
    case word::kIndex_focal_point:
      stream.drop();
      focal_point_ = read_vector(stream, "a point after `focal_point`");
      return true;
    case word::kIndex_blur_samples:
      stream.drop();
      read_samples(stream);
      return true;
    case word::kIndex_confidence:
      stream.drop();
      read_share(stream, blur_.confidence, /*may_be_limit=*/false);
      return true;
    case word::kIndex_variance:
      stream.drop();
      read_share(stream, blur_.variance, /*may_be_limit=*/true);
      return true;
    default: return false;
  }
}

/// `bokeh { pigment { … } }`
void FocalBlurReader::read_bokeh(Context& context, const Element& block) {
  ElementStream stream(context, block);
  if (!stream.peek().is_block(word::kw_pigment)) fail_expected(stream, "a pigment");
  const Element pigment = stream.take();
  blur_.bokeh = read_pigment(context, pigment, {});
  expect_end(stream);
}

/// `blur_samples max` or `blur_samples min, max`.
void FocalBlurReader::read_samples(ElementStream& stream) {
  constexpr double kMaxSamples = 1e6;
  const SourceSpan span = stream.peek().span;
  const double first = std::trunc(read_number(stream, "the number of rays of a pixel"));
  const bool has_second = stream.accept_comma() || stream.peek().is(ElementKind::value);
  const double min = has_second ? first : 0;
  const double max = has_second ? std::trunc(read_number(stream, "the largest number of rays of a pixel")) : first;
  if (!(max >= 1 && max <= kMaxSamples))
    stream.context().fail(span, fmt::format("`blur_samples` must be from 1 to {:g}, found {:g}", kMaxSamples, max));
  if (min > max)
    stream.context().fail(
        span, fmt::format("expected the smaller number of `blur_samples` first, found {:g}, {:g}", min, max));
  blur_.min_samples = static_cast<int>(std::max(min, 0.0));
  blur_.max_samples = static_cast<int>(max);
}

void FocalBlurReader::read_share(ElementStream& stream, double& share, bool may_be_limit) {
  const SourceSpan span = stream.peek().span;
  const double value = read_number(stream, "a number from 0 to 1");
  const bool is_inside = (value > 0 && value < 1) || (may_be_limit && (value == 0 || value == 1));
  if (is_inside) {
    share = value;
  } else {
    stream.context().warn(span,
                          fmt::format("expected a number between 0 and 1, found {:g}; {:g} is used", value, share));
  }
}

std::optional<scene::FocalBlur> FocalBlurReader::result(ElementStream& stream, const scene::Camera& camera) const {
  Context& context = stream.context();
  if (is_pinhole_ && blur_.max_samples > 0)
    context.warn(stream.span(), "an `aperture` of 0 is a pinhole, which makes no blur");
  if (blur_.aperture == 0 || blur_.max_samples == 0) return std::nullopt;
  scene::FocalBlur blur = blur_;
  if (focal_point_) {
    const scene::Vec3 way = *focal_point_ - camera.location;
    // As in POV-Ray, the distance alone counts, in whatever direction the point lies.
    blur.focal_distance = way.length();
    if (blur.focal_distance > 0 && way.dot(camera.direction) <= 0)
      context.warn(stream.span(), "the `focal_point` is not in front of the camera; it is sharp as far away in front");
  } else if (blur.focal_distance == 0) {
    blur.focal_distance = kDefaultFocalDistance;
  }
  if (blur.focal_distance == 0) {
    context.warn(stream.span(), "the `focal_point` is the camera's location; there is no blur");
    return std::nullopt;
  }
  return blur;
}

}  // namespace isl::interpreter
