#include "interpreter/readers/camera.h"

#include "interpreter/readers/arguments.h"
#include "interpreter/readers/focal_blur.h"
#include "interpreter/readers/normal.h"
#include "interpreter/readers/transform.h"
#include "interpreter/transforms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace isl::interpreter {
namespace {

using scene::Camera;
using scene::CameraKind;
using scene::Vec3;
namespace word = grammar::word;

/// POV-Ray's default `right` is 1.33 x, whatever the image's shape.
constexpr Camera kDefault{.right = Vec3(1.33, 0, 0)};
constexpr Vec3 kDefaultLookAt(0, 0, 1);

struct KindWord {
  grammar::Symbol word;
  CameraKind kind;
};
constexpr KindWord kKinds[] = {
    {word::kw_perspective, CameraKind::perspective}, {word::kw_orthographic, CameraKind::orthographic},
    {word::kw_fisheye, CameraKind::fisheye},         {word::kw_ultra_wide_angle, CameraKind::ultra_wide_angle},
    {word::kw_omnimax, CameraKind::omnimax},         {word::kw_panoramic, CameraKind::panoramic},
    {word::kw_cylinder, CameraKind::cylinder},       {word::kw_spherical, CameraKind::spherical}};

/// Whether `angle` sets the length of direction: what then counts is the vectors. Without an angle these kinds take the
/// vectors as they are.
bool is_flat(CameraKind kind) { return kind == CameraKind::perspective || kind == CameraKind::orthographic; }

/// POV-Ray's, where a kind that bends rays has no `angle`.
constexpr double kDefaultAngleDegrees = 90, kSphericalAngleDegrees = 360;

class CameraReader {
 public:
  CameraReader(Context& context, const Element& block) : context_(context), stream_(context, block) {
    if (context.default_camera) copy(*context.default_camera);
    is_copy_ = false;
    camera_.origin = context.origin(block.span);
  }

  Ref<CameraValue> read() {
    if (stream_.peek().is(ElementKind::value)) read_identifier();
    while (!stream_.peek().is(ElementKind::end)) read_item();
    // The order in which a scene writes the items does not matter: the lens, then where it looks, then the transforms.
    check_vectors();
    apply_angle();
    apply_look_at();
    camera_.blur = blur_.result(stream_, camera_);
    camera_.location = transform_.point(camera_.location);
    camera_.direction = transform_.vector(camera_.direction);
    camera_.right = transform_.vector(camera_.right);
    camera_.up = transform_.vector(camera_.up);
    return make_shared_value<CameraValue>(camera_, sky_);
  }

 private:
  void copy(const CameraValue& from) {
    const OriginId origin = camera_.origin;
    camera_ = from.camera;
    camera_.origin = origin;
    sky_ = from.sky;
    blur_ = FocalBlurReader(camera_.blur);
    is_copy_ = true;
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
    static constexpr grammar::Symbol kKnown[] = {
        word::kw_location, word::kw_look_at,   word::kw_angle,    word::kw_right,       word::kw_up,
        word::kw_sky,      word::kw_direction, word::kw_aperture, word::kw_focal_point, word::kw_blur_samples};
    const Element next = stream_.peek();
    if (next.is_block(word::kw_normal)) {
      stream_.drop();
      camera_.normal = read_normal(context_, next, camera_.normal);
      return;
    }
    if (blur_.read(stream_)) return;
    if (!next.is(ElementKind::word)) return refuse(stream_, kKnown);
    if (read_kind(next.word)) return;
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
      default: return refuse(stream_, kKnown);
    }
    stream_.drop();
    has_size_ |= vector == &camera_.right || vector == &camera_.up;
    *vector = read_after(context_.text(next.word));
  }

  bool read_kind(grammar::Symbol name) {
    const auto* const row = std::ranges::find(kKinds, name, &KindWord::word);
    if (row == std::end(kKinds)) return false;
    stream_.drop();
    camera_.kind = row->kind;
    camera_.cylinder_type = 0;
    if (row->kind == CameraKind::cylinder)
      camera_.cylinder_type = static_cast<int>(read_number_in(stream_, "the type of a cylindrical camera", 1, 4));
    return true;
  }

  /// `angle horizontal`, and for a spherical camera `angle horizontal, vertical`.
  void read_angle() {
    stream_.drop();
    angle_span_ = stream_.peek().span;
    angle_degrees_ = read_number(stream_, "a number after `angle`");
    vertical_degrees_.reset();
    if (camera_.kind != CameraKind::spherical) return;
    const bool has_vertical = stream_.accept_comma() || stream_.peek().is(ElementKind::value);
    if (has_vertical) vertical_degrees_ = read_number(stream_, "the vertical angle of a spherical camera");
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

  void apply_angle() {
    if (angle_degrees_ && *angle_degrees_ < 0)
      context_.fail(angle_span_, fmt::format("`angle` is not below 0, found {:g}", *angle_degrees_));
    if (is_flat(camera_.kind)) {
      camera_.angle = camera_.vertical_angle = 0;
      apply_flat_angle();
      if (camera_.kind == CameraKind::orthographic) apply_orthographic_size();
    } else {
      apply_bent_angle();
    }
  }

  /// The horizontal angle between the left and the right edge sets the length of direction. As in POV-Ray, none is the
  /// same as 0.
  void apply_flat_angle() {
    if (!angle_degrees_ || *angle_degrees_ == 0) return;
    if (*angle_degrees_ >= 180)
      context_.fail(angle_span_, fmt::format("`angle` is below 180 degrees, found {:g}", *angle_degrees_));
    const double length = camera_.right.length() / (2 * std::tan(radians_from_degrees(*angle_degrees_) / 2));
    camera_.direction *= length / camera_.direction.length();
  }

  /// A parallel view without a size of its own, or with an angle, shows at look_at what a perspective one would.
  void apply_orthographic_size() {
    const bool has_angle = angle_degrees_ && *angle_degrees_ != 0;
    if (is_copy_ || (has_size_ && !has_angle)) return;
    const double distance = (look_at_.value_or(kDefaultLookAt) - camera_.location).length();
    if (!(distance > 0)) return;
    camera_.right *= distance / camera_.direction.length();
    camera_.up *= distance / camera_.direction.length();
  }

  void apply_bent_angle() {
    const bool is_spherical = camera_.kind == CameraKind::spherical;
    if (camera_.kind == CameraKind::omnimax || (is_copy_ && !angle_degrees_)) return;  // its picture is always the same
    const double degrees = angle_degrees_.value_or(is_spherical ? kSphericalAngleDegrees : kDefaultAngleDegrees);
    camera_.angle = radians_from_degrees(degrees);
    if (is_spherical) camera_.vertical_angle = radians_from_degrees(vertical_degrees_.value_or(degrees / 2));
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
  bool is_copy_ = false;   ///< of a camera that was declared
  bool has_size_ = false;  ///< `right` or `up` was given
  FocalBlurReader blur_;
  std::optional<double> angle_degrees_, vertical_degrees_;
  SourceSpan angle_span_;
  std::optional<Vec3> look_at_;
  SourceSpan look_at_span_;
};

}  // namespace

Ref<CameraValue> read_camera(Context& context, const Element& block) { return CameraReader(context, block).read(); }

}  // namespace isl::interpreter
