#include "interpreter/readers/camera.h"

#include "interpreter/readers/arguments.h"
#include "interpreter/readers/transform.h"
#include "interpreter/transforms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isl::interpreter {
namespace {

using scene::Camera;
using scene::Vec3;
namespace word = grammar::word;

/// POV-Ray's default `right` is 1.33 x, whatever the image's shape.
constexpr Camera kDefault{.right = Vec3(1.33, 0, 0)};

bool is_other_type(grammar::Symbol name) {
  static constexpr grammar::Symbol kTypes[] = {word::kw_orthographic, word::kw_fisheye,   word::kw_ultra_wide_angle,
                                               word::kw_omnimax,      word::kw_panoramic, word::kw_spherical,
                                               word::kw_cylinder};
  return std::ranges::find(kTypes, name) != std::end(kTypes);
}

class CameraReader {
 public:
  CameraReader(Context& context, const Element& block) : context_(context), stream_(context, block) {
    if (context.default_camera) copy(*context.default_camera);
  }

  Ref<CameraValue> read() {
    if (stream_.peek().is(ElementKind::value)) read_identifier();
    while (!stream_.peek().is(ElementKind::end)) read_item();
    // The order in which a scene writes the items does not matter: the lens, then where it looks, then the transforms.
    check_vectors();
    apply_angle();
    apply_look_at();
    camera_.location = transform_.point(camera_.location);
    camera_.direction = transform_.vector(camera_.direction);
    camera_.right = transform_.vector(camera_.right);
    camera_.up = transform_.vector(camera_.up);
    return make_shared_value<CameraValue>(camera_, sky_);
  }

 private:
  void copy(const CameraValue& from) {
    camera_ = from.camera;
    sky_ = from.sky;
  }

  void read_identifier() {
    const SourceSpan span = stream_.peek().span;
    const Value value = stream_.take_value();
    if (value.kind() != ValueKind::camera)
      context_.fail(span, fmt::format("expected a camera or its items, found {}", describe(value)));
    copy(value.as<CameraValue>());
  }

  Vec3 read_after(std::string_view name) { return read_vector(stream_, fmt::format("a vector after `{}`", name)); }

  void read_item() {
    if (const std::optional<scene::Transform> transform = read_transform(stream_)) {
      transform_ = scene::then(transform_, *transform);
      return;
    }
    static constexpr grammar::Symbol kKnown[] = {word::kw_location, word::kw_look_at, word::kw_angle,    word::kw_right,
                                                 word::kw_up,       word::kw_sky,     word::kw_direction};
    const Element next = stream_.peek();
    if (!next.is(ElementKind::word)) return refuse(stream_, kKnown);
    if (is_other_type(next.word)) {
      stream_.drop();
      has_other_type_ = true;
      context_.unsupported(next.span, context_.text(next.word));
      if (stream_.peek().is(ElementKind::value)) stream_.drop();  // `cylinder 1`
      return;
    }
    Vec3* vector = nullptr;
    switch (static_cast<word::Index>(next.word)) {
      case word::kIndex_location: vector = &camera_.location; break;
      case word::kIndex_direction: vector = &camera_.direction; break;
      case word::kIndex_right: vector = &camera_.right; break;
      case word::kIndex_up: vector = &camera_.up; break;
      case word::kIndex_sky: vector = &sky_; break;
      case word::kIndex_look_at:
        stream_.drop();
        look_at_span_ = stream_.peek().span;
        look_at_ = read_after("look_at");
        return;
      case word::kIndex_angle: return read_angle();
      case word::kIndex_perspective: return stream_.drop();
      default: return refuse(stream_, kKnown);
    }
    stream_.drop();
    *vector = read_after(context_.text(next.word));
  }

  void read_angle() {
    stream_.drop();
    angle_span_ = stream_.peek().span;
    angle_degrees_ = read_number(stream_, "a number after `angle`");
  }

  void check_vectors() {
    const auto check = [&](const Vec3& v, std::string_view name) {
      if (!(v.length() > 0)) context_.fail(stream_.span(), fmt::format("the camera's `{}` has length zero", name));
    };
    check(camera_.direction, "direction");
    check(camera_.right, "right");
    check(camera_.up, "up");
    check(sky_, "sky");
  }

  /// The horizontal angle between the left and the right edge sets the length of direction.
  void apply_angle() {
    // The angle of a fisheye is not a perspective's.
    if (!angle_degrees_ || has_other_type_) return;
    if (!(*angle_degrees_ > 0 && *angle_degrees_ < 180)) {
      context_.fail(angle_span_, fmt::format("`angle` is above 0 and below 180 degrees, found {:g}", *angle_degrees_));
    }
    const double length = camera_.right.length() / (2 * std::tan(radians_from_degrees(*angle_degrees_) / 2));
    camera_.direction *= length / camera_.direction.length();
  }

  /// Turns the camera to the point, with `sky` above it; lengths and handedness stay.
  void apply_look_at() {
    if (!look_at_) return;
    const Vec3 ahead = *look_at_ - camera_.location;
    if (!(ahead.length() > 0)) context_.fail(look_at_span_, "`location` and `look_at` are the same point");
    const double direction = camera_.direction.length(), right = camera_.right.length(), up = camera_.up.length();
    const bool is_mirrored = camera_.up.cross(camera_.direction).dot(camera_.right) < 0;
    const Vec3 forward = ahead / ahead.length();
    Vec3 sideways = sky_.cross(forward);
    // Straight along the sky there is no sideways; as in POV-Ray, it is what the camera's own right was.
    if (!(sideways.length() > 1e-12 * sky_.length())) {
      sideways = camera_.right - forward * camera_.right.dot(forward);
      if (!(sideways.length() > 1e-12 * right)) sideways = forward.cross(Vec3(forward.y, forward.z, -forward.x));
    }
    sideways /= sideways.length();
    camera_.direction = forward * direction;
    camera_.up = forward.cross(sideways) * up;
    camera_.right = sideways * (is_mirrored ? -right : right);
  }

  Context& context_;
  ElementStream stream_;
  Camera camera_ = kDefault;
  Vec3 sky_{0, 1, 0};
  scene::Transform transform_;
  bool has_other_type_ = false;  ///< not perspective: read on with --lenient only
  std::optional<double> angle_degrees_;
  SourceSpan angle_span_;
  std::optional<Vec3> look_at_;
  SourceSpan look_at_span_;
};

}  // namespace

Ref<CameraValue> read_camera(Context& context, const Element& block) { return CameraReader(context, block).read(); }

}  // namespace isl::interpreter
