#include "interpreter/readers/view/camera.h"

#include "interpreter/newer_words.h"
#include "interpreter/readers/patterns/pattern_operands.h"
#include "interpreter/readers/textures/normal.h"
#include "interpreter/readers/view/camera_pose.h"
#include "interpreter/readers/view/focal_blur.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/said_at.h"
#include "interpreter/readers/words/transform.h"
#include "interpreter/transforms.h"
#include "renderer/scene/default_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace isl::interpreter {
namespace {

using scene::Camera;
using scene::CameraItem;
using scene::CameraKind;
using scene::Vec3;
namespace word = grammar::word;

constexpr Vec3 kDefaultLookAt(0, 0, 1);

struct KindWord {
  grammar::Symbol word;
  CameraKind kind;
};
constexpr KindWord kCameraKinds[] = {
    {word::kw_perspective, CameraKind::perspective}, {word::kw_orthographic, CameraKind::orthographic},
    {word::kw_fisheye, CameraKind::fisheye},         {word::kw_ultra_wide_angle, CameraKind::ultra_wide_angle},
    {word::kw_omnimax, CameraKind::omnimax},         {word::kw_panoramic, CameraKind::panoramic},
    {word::kw_cylinder, CameraKind::cylinder},       {word::kw_spherical, CameraKind::spherical}};

/// True for the kinds whose rays are straight: `angle` sets the length of direction, and only the vectors count.
bool is_flat(CameraKind kind) { return kind == CameraKind::perspective || kind == CameraKind::orthographic; }

/// True for the kinds whose rays do not depend on an angle of the record.
bool has_no_angle(CameraKind kind) { return is_flat(kind) || kind == CameraKind::user_defined; }

/// POV-Ray's defaults for the kinds that bend rays, if there is no `angle`.
constexpr double kDefaultAngleDegrees = 90, kSphericalAngleDegrees = 360;

constexpr ItemWord<CameraItem> kCameraPlaces[] = {{word::kw_aperture, CameraItem::blur},
                                                  {word::kw_normal, CameraItem::normal}};

class CameraReader {
 public:
  CameraReader(Context& context, const Element& block)
      : context_(context),
        stream_(context, block),
        camera_(scene::default_camera(context.options.image_width, context.options.image_height)),
        is_in_order_(context.version.number() < 3.5),
        size_span_(block.word_span) {
    if (context.default_camera) copy(*context.default_camera);
    is_copy_ = false;
    camera_.origin = context.origin(block.span);
  }

  Ref<CameraValue> read() {
    if (stream_.peek().is(ElementKind::value)) read_identifier();
    while (!stream_.peek().is(ElementKind::end)) read_item();
    // From 3.5 on, the order in which a scene writes the items does not matter: first the lens, then the direction of
    // view, then the transforms.
    if (!is_in_order_) apply_angle();
    apply_size();
    if (!is_in_order_) apply_look_at();
    check_vectors();
    camera_.blur = blur_.result(stream_, camera_);
    camera_.location = transform_.point(camera_.location);
    camera_.direction = transform_.vector(camera_.direction);
    camera_.right = transform_.vector(camera_.right);
    camera_.up = transform_.vector(camera_.up);
    return make_shared_value<CameraValue>(camera_, sky_, size_span_);
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
    note_place(context_, next, kCameraPlaces, camera_.said_at);
    if (next.is_block(word::kw_normal)) {
      stream_.drop();
      camera_.normal = read_normal(context_, next, camera_.normal);
      return;
    }
    if (blur_.read(stream_)) return;
    if (next.word == grammar::newer_word::kw_user_defined) return read_user_defined();
    if (camera_.kind == CameraKind::user_defined && read_user_item()) return;
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
        if (is_in_order_) apply_look_at();
        return;
      case word::kIndex_angle:
        read_angle();
        if (is_in_order_) apply_angle();
        return;
      default: return refuse(stream_, kKnown);
    }
    stream_.drop();
    has_size_ |= vector == &camera_.right || vector == &camera_.up;
    if (vector == &camera_.right) size_span_ = stream_.peek().span;
    *vector = read_after(context_.text(next.word));
  }

  void read_user_defined() {
    const Element next = stream_.take();
    note_newer_word(context_, next.word, next.span);
    camera_.said_at[CameraItem::kind] = place_of(context_, next);
    camera_.kind = CameraKind::user_defined;
    camera_.location_of = camera_.direction_of = scene::kNoVectorFunctions;
  }

  /// `location` or `direction` of a user-defined camera: a vector, or a block of three functions.
  bool read_user_item() {
    const Element next = stream_.peek();
    if (next.word != word::kw_location && next.word != word::kw_direction) return false;
    const bool is_location = next.word == word::kw_location;
    scene::VectorFunctions& functions = is_location ? camera_.location_of : camera_.direction_of;
    Vec3& vector = is_location ? camera_.location : camera_.direction;
    functions = scene::kNoVectorFunctions;
    stream_.drop();
    if (!next.is(ElementKind::block)) {
      vector = read_after(context_.text(next.word));
      return true;
    }
    ElementStream stream(context_, next);
    for (scene::FunctionId& function : functions) {
      function = read_function_operand(stream);
      stream.accept_comma();
    }
    expect_end(stream);
    return true;
  }

  bool read_kind(grammar::Symbol name) {
    const auto* const row = std::ranges::find(kCameraKinds, name, &KindWord::word);
    if (row == std::end(kCameraKinds)) return false;
    camera_.said_at[CameraItem::kind] = place_of(context_, stream_.peek());
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
    if (sky_ == Vec3(0))
      context_.warn(stream_.span(), "the camera's `sky` has length zero; its `right` is used instead");
  }

  /// The angle of a view with straight rays. As in POV-Ray, an angle of 0 leaves `direction` as it is.
  void apply_angle() {
    if (angle_degrees_ && *angle_degrees_ < 0)
      context_.fail(angle_span_, fmt::format("`angle` must be at least 0, found {:g}", *angle_degrees_));
    if (!is_flat(camera_.kind) || !angle_degrees_ || *angle_degrees_ == 0) return;
    if (*angle_degrees_ >= 180)
      context_.fail(angle_span_, fmt::format("`angle` must be below 180 degrees, found {:g}", *angle_degrees_));
    check_vectors();
    set_horizontal_angle(camera_, *angle_degrees_);
  }

  void apply_size() {
    if (has_no_angle(camera_.kind)) {
      camera_.angle = camera_.vertical_angle = 0;
    } else {
      apply_bent_angle();
    }
    if (camera_.kind == CameraKind::orthographic) apply_orthographic_size();
  }

  /// A parallel view without a size of its own, or with an angle, be it 0, shows at look_at the same section as a
  /// perspective one.
  void apply_orthographic_size() {
    if (is_copy_ || (has_size_ && !angle_degrees_)) return;
    const double distance = (look_at_.value_or(kDefaultLookAt) - camera_.location).length();
    if (!(distance > 0)) return;
    camera_.right *= distance / camera_.direction.length();
    camera_.up *= distance / camera_.direction.length();
  }

  void apply_bent_angle() {
    const bool is_spherical = camera_.kind == CameraKind::spherical;
    // The picture of these does not depend on `angle`.
    if (camera_.kind == CameraKind::omnimax || (is_copy_ && !angle_degrees_)) return;
    const double degrees = angle_degrees_.value_or(is_spherical ? kSphericalAngleDegrees : kDefaultAngleDegrees);
    camera_.angle = radians_from_degrees(degrees);
    if (is_spherical) camera_.vertical_angle = radians_from_degrees(vertical_degrees_.value_or(degrees / 2));
  }

  void apply_look_at() {
    if (!look_at_) return;
    check_vectors();
    if (*look_at_ == camera_.location) context_.fail(look_at_span_, "`location` and `look_at` are the same point");
    look_at(camera_, *look_at_, sky_);
  }

  Context& context_;
  ElementStream stream_;
  Camera camera_;
  Vec3 sky_{0, 1, 0};
  scene::Transform transform_;
  bool is_in_order_;       ///< before 3.5, each item works on the items before it
  bool is_copy_ = false;   ///< copied from a declared camera
  SourceSpan size_span_;   ///< span of `right`, else of the word `camera`
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
