// A camera's focal blur: aperture, focal_point, blur_samples, confidence, variance, bokeh. Only the reader of cameras
// uses it.
#pragma once

#include "interpreter/element_stream.h"

#include <optional>

namespace isl::interpreter {

class FocalBlurReader {
 public:
  FocalBlurReader() = default;
  /// Starts from the focal blur of a declared camera.
  explicit FocalBlurReader(const std::optional<scene::FocalBlur>& blur);

  /// Reads one item if the next element is one.
  [[nodiscard]] bool read(ElementStream& stream);

  /// Nullopt if the aperture is 0 or the scene sets no samples: in POV-Ray everything is then sharp. `camera` has its
  /// location and direction before its transforms, which do not change the focal distance.
  [[nodiscard]] std::optional<scene::FocalBlur> result(ElementStream& stream, const scene::Camera& camera) const;

 private:
  void read_bokeh(Context& context, const Element& block);
  void read_samples(ElementStream& stream);
  /// Reads a number; if it is out of range, warns and takes the default.
  void read_share(ElementStream& stream, double& share, bool may_be_limit);

  scene::FocalBlur blur_;
  std::optional<scene::Vec3> focal_point_;
  bool is_pinhole_ = false;  ///< the scene says so
};

}  // namespace isl::interpreter
