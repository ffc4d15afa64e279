#include "interpreter/readers/view/picture_shape.h"

#include <fmt/format.h>

#include <cmath>

namespace isl::interpreter {
namespace {

using scene::Camera;
using scene::CameraKind;
using scene::Vec3;

/// The kinds whose picture has the lengths of `right` and of `up` as its sides.
bool has_sides(CameraKind kind) {
  return kind == CameraKind::perspective || kind == CameraKind::orthographic || kind == CameraKind::fisheye ||
         kind == CameraKind::ultra_wide_angle || kind == CameraKind::omnimax;
}

/// Shapes are written with two decimals, as 1.33 for 4/3, and sizes are rounded to whole pixels, as 853x480 for 16:9: a
/// shape within both roundings is the picture's own.
bool fits(double shape, double width, double height) {
  constexpr double kTwoDecimals = 0.005;
  const double narrowest = (width - 0.5) / (height + 0.5), widest = (width + 0.5) / (height - 0.5);
  return shape >= narrowest - kTwoDecimals && shape <= widest + kTwoDecimals;
}

/// "-x" if the vector lies along an axis, else empty.
std::string axis_of(const Vec3& v) {
  static constexpr std::string_view kAxes = "xyz";
  for (int i = 0; i < 3; ++i) {
    if (std::abs(v[i]) == v.length())
      return fmt::format("{}{}", v[i] < 0 ? "-" : "", kAxes[static_cast<std::size_t>(i)]);
  }
  return {};
}

std::string fitting_right(const Camera& camera) {
  const std::string axis = axis_of(camera.right);
  const double up = camera.up.length();
  if (axis.empty()) return fmt::format("a `right` of length {:.4g}*image_width/image_height fits every picture", up);
  const std::string factor = up == 1 ? "" : fmt::format("{:.4g}*", up);
  return fmt::format("`right {}{}*image_width/image_height` fits every picture", factor, axis);
}

}  // namespace

void check_shape(Context& context, const Camera& camera, SourceSpan span) {
  const double width = context.options.image_width, height = context.options.image_height;
  if (!context.options.is_size_known || !has_sides(camera.kind)) return;
  const double shape = camera.right.length() / camera.up.length();
  if (fits(shape, width, height)) return;
  context.warn(
      span,
      fmt::format("the picture is stretched: `right` is {:.4g} times as long as `up`, but the picture is {:.4g} "
                  "times as wide as high",
                  shape, width / height),
      fitting_right(camera));
}

}  // namespace isl::interpreter
