// A camera's focal blur: aperture, focal_point, blur_samples, confidence, variance, bokeh. Only the reader of cameras
// uses it.
#pragma once

#include "interpreter/element_stream.h"

#include <optional>

namespace isl::interpreter {

class FocalBlurReader {
 public:
  FocalBlurReader() = default;
  /// Begins with a declared camera's.
  explicit FocalBlurReader(const std::optional<scene::FocalBlur>& blur);

  /// Reads one item if the next element is one.
  [[nodiscard]] bool read(ElementStream& stream);

  /// None where the lens is a point or no samples are asked for, which in POV-Ray means that everything is sharp.
  /// `camera` is where it stands and looks before its transforms: these do not change the distance that is sharp.
  [[nodiscard]] std::optional<scene::FocalBlur> result(ElementStream& stream, const scene::Camera& camera) const;

 private:
  void read_bokeh(Context& context, const Element& block);
  void read_samples(ElementStream& stream);
  /// A number, or the default with a warning where it is out of its range.
  void read_share(ElementStream& stream, double& share, bool may_be_limit);

  scene::FocalBlur blur_;
  std::optional<scene::Vec3> focal_point_;
};

}  // namespace isl::interpreter
