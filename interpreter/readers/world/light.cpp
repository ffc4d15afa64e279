// `light_source { <location>, colour … }`, of every kind.
#include "interpreter/expressions.h"
#include "interpreter/readers/objects/objects.h"
#include "interpreter/readers/objects/solid_draft.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/colour.h"
#include "interpreter/readers/words/said_at.h"
#include "interpreter/readers/words/transform.h"
#include "interpreter/transforms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace isl::interpreter {
namespace {

using scene::AreaLight;
using scene::Light;
using scene::LightItem;
using scene::LightKind;
namespace word = grammar::word;

class LightReader {
 public:
  LightReader(ElementStream& stream, ObjectDraft& draft) : stream_(stream), context_(stream.context()), draft_(draft) {}

  void read() {
    light_.area.emplace();  // so that transforms move it; finish() takes it away if there is none
    light_.origin = draft_.object.origin;
    light_.location = read_vector(stream_, "the location of the light");
    stream_.accept_comma();
    light_.colour = read_colour(stream_);
    while (!stream_.peek().is(ElementKind::end)) {
      note_place(context_, stream_.peek(), kPlaces, light_.said_at);
      if (!read_item()) refuse(stream_, kKnown);
    }
    finish();
    context_.count_primitive(stream_.span(), sizeof(Light) + kOriginBytes);
    draft_.lights.push_back(light_);
  }

 private:
  static constexpr grammar::Symbol kKnown[] = {
      word::kw_spotlight,  word::kw_cylinder,   word::kw_parallel,          word::kw_area_light,    word::kw_radius,
      word::kw_falloff,    word::kw_tightness,  word::kw_point_at,          word::kw_fade_distance, word::kw_fade_power,
      word::kw_shadowless, word::kw_looks_like, word::kw_projected_through, word::kw_translate,     word::kw_rotate};

  static constexpr ItemWord<LightItem> kPlaces[] = {{word::kw_spotlight, LightItem::kind},
                                                    {word::kw_cylinder, LightItem::kind},
                                                    {word::kw_parallel, LightItem::parallel},
                                                    {word::kw_area_light, LightItem::area},
                                                    {word::kw_jitter, LightItem::jitter},
                                                    {word::kw_fade_distance, LightItem::fade},
                                                    {word::kw_projected_through, LightItem::projected_through}};

  bool read_item() {
    if (const std::optional<scene::Transform> transform = read_transform(stream_)) {
      scene::move(light_, *transform);
      draft_.object.parent_from_object = scene::then(draft_.object.parent_from_object, *transform);
      return true;
    }
    const Element next = stream_.peek();
    if (next.is(ElementKind::block)) return read_object_item(next);
    return next.is(ElementKind::word) && (read_kind(next.word) || read_number_item(next) || read_word(next));
  }

  /// Reads the kind of light; each kind has its own defaults, which are POV-Ray's.
  bool read_kind(grammar::Symbol name) {
    if (name == word::kw_spotlight) {
      light_.kind = LightKind::spotlight;
      light_.radius = radians_from_degrees(30);
      light_.falloff = radians_from_degrees(45);
    } else if (name == word::kw_cylinder) {
      light_.kind = LightKind::cylinder;
      light_.radius = 0.75;
      light_.falloff = 1;
    } else {
      return false;
    }
    light_.tightness = 0;
    stream_.drop();
    return true;
  }

  void need_beam(const Element& item) {
    if (light_.kind != LightKind::point) return;
    context_.fail(item.span,
                  fmt::format("`{}` needs the word `spotlight` or `cylinder` before it", context_.text(item.word)));
  }

  /// Reads items of one number. Angles of a spotlight are in degrees in this interface.
  bool read_number_item(const Element& item) {
    struct NumberItem {
      grammar::Symbol word;
      double Light::*member;
      bool is_of_beam;
      bool is_angle;
    };
    static constexpr NumberItem kItems[] = {{word::kw_radius, &Light::radius, true, true},
                                            {word::kw_falloff, &Light::falloff, true, true},
                                            {word::kw_tightness, &Light::tightness, true, false},
                                            {word::kw_fade_distance, &Light::fade_distance, false, false},
                                            {word::kw_fade_power, &Light::fade_power, false, false}};
    const auto* const row = std::ranges::find(kItems, item.word, &NumberItem::word);
    if (row == std::end(kItems)) return false;
    if (row->is_of_beam) need_beam(item);
    stream_.drop();
    const SourceSpan span = stream_.peek().span;
    const double number = read_number(stream_, fmt::format("a number after `{}`", context_.text(item.word)));
    if (!std::isfinite(number))
      context_.fail(span, fmt::format("`{}` must be finite, found {:g}", context_.text(item.word), number));
    if (item.word == word::kw_fade_distance && number < 0)
      context_.warn(span, fmt::format("`fade_distance` must be above 0, found {:g}: this light does not fade", number));
    light_.*row->member = row->is_angle && light_.kind == LightKind::spotlight ? radians_from_degrees(number) : number;
    return true;
  }

  bool read_word(const Element& item) {
    switch (static_cast<word::Index>(item.word)) {
      case word::kIndex_shadowless: stream_.drop(); return light_.shadowless = true;
      case word::kIndex_parallel: stream_.drop(); return light_.parallel = true;
      case word::kIndex_jitter: stream_.drop(); return area().jitter = true;
      case word::kIndex_circular: stream_.drop(); return area().circular = true;
      case word::kIndex_orient: stream_.drop(); return area().orient = true;
      case word::kIndex_point_at:
        if (!light_.parallel) need_beam(item);
        stream_.drop();
        light_.point_at = read_vector(stream_, "a point after `point_at`");
        return true;
      case word::kIndex_area_light: stream_.drop(); return read_area();
      case word::kIndex_adaptive:
        stream_.drop();
        area().adaptive = static_cast<int>(read_nearest_number(stream_, "`adaptive`", 0, 20));
        return true;
      case word::kIndex_area_illumination:
        stream_.drop();
        area().area_illumination = read_optional_truth(stream_);
        return true;
      case word::kIndex_media_interaction:
        stream_.drop();
        light_.media_interaction = read_optional_truth(stream_);
        return true;
      case word::kIndex_media_attenuation:
        stream_.drop();
        light_.media_attenuation = read_optional_truth(stream_);
        return true;
      default: return false;
    }
  }

  /// `area_light edge, edge, count, count`
  bool read_area() {
    has_area_ = true;
    area().edge_a = read_vector(stream_, "an edge of the area light");
    stream_.accept_comma();
    area().edge_b = read_vector(stream_, "the other edge of the area light");
    stream_.accept_comma();
    area().count_a = read_count();
    stream_.accept_comma();
    area().count_b = read_count();
    return true;
  }

  int read_count() {
    constexpr double kMaxCount = 10000;
    const SourceSpan span = stream_.peek().span;
    const double count = std::trunc(std::abs(read_number(stream_, "the number of lights along the edge")));
    if (!(count >= 1 && count <= kMaxCount)) {
      context_.fail(span, fmt::format("an area light must have from 1 to {:g} lights along an edge, found {:g}",
                                      kMaxCount, count));
    }
    return static_cast<int>(count);
  }

  // ---- Objects that belong to a light -------------------------------------------------------------------------------

  bool read_object_item(const Element& block) {
    if (block.word == word::kw_looks_like) {
      if (looks_like_) context_.fail(block.word_span, "a light has at most one `looks_like`, found a second");
      stream_.drop();
      read_looks_like(block);
      return looks_like_ = true;
    }
    if (block.word == word::kw_projected_through) {
      stream_.drop();
      scene::Group group;
      read_only_child(block, group);
      light_.projected_through = add_group(stream_, std::move(group));
      light_.world_from_projected = {};
      return true;
    }
    return false;
  }

  void read_only_child(const Element& block, scene::Group& group) {
    ElementStream inner(context_, block);
    const Ref<ObjectValue> child = read_child(inner);
    if (!child) fail_expected(inner, "an object");
    if (child->object.shape != scene::kNone) group.children.push_back(placed(context_, *child));
    expect_end(inner);
  }

  /// The object is placed at the light and does not block its light: an ordinary object without a shadow, which moves
  /// with the light.
  void read_looks_like(const Element& block) {
    scene::Group group;
    read_only_child(block, group);
    for (scene::Object& child : group.children) {
      child.no_shadow = true;
      // The transforms of the light so far move the object through the draft's transform, to the light's location
      // before them.
      const scene::Vec3 location = draft_.object.parent_from_object.inverse_point(light_.location);
      child.parent_from_object = scene::then(child.parent_from_object, translation(location));
    }
    set_group(stream_, draft_, std::move(group));
  }

  // ---- The whole ----------------------------------------------------------------------------------------------------

  void finish() {
    light_.fades_from_point =
        light_.fade_distance == 0 && context_.version.number() >= LanguageVersion::kWithNewerWords;
    if (light_.area->orient) check_orient();
    if (!has_area_) return light_.area.reset();
    const AreaLight& area = *light_.area;
    const bool is_point = area.edge_a.length() == 0 && area.edge_b.length() == 0;
    if (is_point && area.count_a * area.count_b > 1)
      context_.warn(stream_.span(), "both edges of this area light are 0, so it throws the hard shadows of a point");
  }

  /// A light that turns to the lit point looks the same from everywhere.
  void check_orient() {
    if (!has_area_) return context_.warn(stream_.span(), "`orient` has no effect without `area_light`");
    if (!area().circular) context_.warn(stream_.span(), "`orient` makes this area light circular");
    area().circular = true;
    if (std::abs(area().edge_a.length() - area().edge_b.length()) > kTolerance)
      context_.warn(stream_.span(), "with `orient` both edges get the length of the first");
    if (area().count_a != area().count_b)
      context_.warn(stream_.span(), "with `orient` both edges should have the same number of lights");
  }

  AreaLight& area() { return *light_.area; }

  ElementStream& stream_;
  Context& context_;
  ObjectDraft& draft_;
  Light light_;
  bool has_area_ = false;
  bool looks_like_ = false;
};

}  // namespace

void read_light_source(ElementStream& stream, ObjectDraft& draft) {
  if (!read_copy(stream, draft)) LightReader(stream, draft).read();
}

}  // namespace isl::interpreter
