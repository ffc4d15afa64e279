#include "interpreter/readers/textures/pigment.h"

#include "interpreter/readers/patterns/pattern.h"
#include "interpreter/readers/patterns/pattern_operands.h"
#include "interpreter/readers/textures/default_maps.h"
#include "interpreter/readers/textures/maps.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/colour.h"
#include "interpreter/readers/words/said_at.h"
#include "interpreter/readers/words/transform.h"
#include "interpreter/records.h"

#include <fmt/format.h>

namespace isl::interpreter {
namespace {

using scene::PatternedPigment;
using scene::PatternKind;
using scene::Pigment;
namespace word = grammar::word;

constexpr grammar::Symbol kPigmentWords[] = {
    word::kw_color,       word::kw_rgb,        word::kw_srgb,      word::kw_transmit,  word::kw_color_map,
    word::kw_pigment_map, word::kw_turbulence, word::kw_gradient,  word::kw_checker,   word::kw_image_map,
    word::kw_scale,       word::kw_rotate,     word::kw_translate, word::kw_frequency, word::kw_phase};

bool is_map_block(const Element& next) {
  return next.is_block(word::kw_color_map) || next.is_block(word::kw_colour_map) || next.is_block(word::kw_pigment_map);
}

bool takes_map(PatternKind kind) { return kind != PatternKind::plain && render::info_of(kind).takes_map(); }

bool is_mean(PatternKind kind) { return render::info_of(kind).choice == render::PatternChoice::mean_of_map; }

Pigment with_record(Context& context, PatternedPigment&& record) {
  return {.pattern = add_record<scene::PigmentId>(context, context.database.pigments, std::move(record))};
}

/// How the pattern is moved, apart from its warps and turbulence.
scene::Transform transforms_of(const Context& context, const scene::Pattern& pattern) {
  scene::Transform total;
  for (const scene::Warp& warp : pattern.warps) {
    if (const auto* const transform = std::get_if<scene::TransformId>(&warp))
      total = scene::then(total, context.database.transforms[index(*transform)]);
  }
  return total;
}

class PigmentReader {
 public:
  /// `plain_moved`: how `base` was moved while it was a plain colour.
  PigmentReader(ElementStream& stream, const Pigment& base, const scene::Transform& plain_moved)
      : stream_(stream), context_(stream.context()), pigment_(base), plain_moved_(plain_moved) {}

  /// How the result was moved, if it is a plain colour.
  [[nodiscard]] const scene::Transform& plain_moved() const { return plain_moved_; }

  Pigment read() {
    bool has_type = read_identifier();
    if (stream_.peek().is_word(word::kw_uv_mapping)) {
      stream_.drop();
      open();
      draft_.pattern.uv_mapping = true;
      has_type = read_identifier() || has_type;
    }
    if (read_type()) has_type = true;
    while (!stream_.peek().is(ElementKind::end)) {
      if (!read_modifier(has_type)) refuse(stream_, kPigmentWords);
    }
    return close();
  }

 private:
  /// Reads a declared pigment, or a declared colour with its overrides.
  bool read_identifier() {
    const Element first = stream_.peek();
    if (!first.is(ElementKind::value) || first.node->kind == grammar::NodeKind::function) return false;
    const Value value = stream_.take_value();
    if (value.kind() == ValueKind::pigment) {
      const bool uv_mapping = record_ && draft_.pattern.uv_mapping;
      pigment_ = value.as<PigmentValue>().pigment;
      plain_moved_ = value.as<PigmentValue>().plain_moved;
      is_declared_on_surface_ =
          !pigment_.is_plain() && context_.database.pigments[index(pigment_.pattern)].pattern.uv_mapping;
      record_.reset();
      if (uv_mapping) {
        open();
        draft_.pattern.uv_mapping = true;
      }
    } else if (value.is_numeric() && first.node->kind != grammar::NodeKind::vector) {
      set_colour(to_colour(read_colour_after(stream_, value)), first);
    } else {
      context_.fail(first.span, fmt::format("expected a pigment or colour, found {}", describe(value)),
                    value.is_numeric() ? "write `rgb` before it" : "");
    }
    return true;
  }

  bool read_type() {
    const Element next = stream_.peek();
    if (next.is(ElementKind::word) && is_colour_word(next.word)) {
      set_colour(read_colour(stream_), next);
      return true;
    }
    if (!starts_pattern(context_, next)) return false;
    PatternedPigment& record = open();
    const bool had_list = !takes_map(draft_.pattern.kind);
    scene::PigmentMapId list = scene::kNoPigmentMap;
    const ReadList read_list = [&](ElementStream& stream, PatternKind kind, int count) {
      list = read_pigment_list(stream, kind, count);
    };
    static_cast<void>(read_pattern(stream_, draft_, PatternHost::pigment, read_list));
    if (had_list || !takes_map(draft_.pattern.kind)) record.map = list;
    return true;
  }

  bool read_modifier(bool has_type) {
    // A plain colour is the same after every transform.
    if (!record_ && pigment_.is_plain()) {
      if (const std::optional<scene::Transform> transform = read_transform(stream_)) {
        plain_moved_ = scene::then(plain_moved_, *transform);
        return true;
      }
    }
    const Element next = stream_.peek();
    if (is_map_block(next)) {
      stream_.drop();
      read_map(next, has_type);
      return true;
    }
    if (next.is_word(word::kw_quick_color) || next.is_word(word::kw_quick_colour)) {
      stream_.drop();
      open().quick_colour = read_colour(stream_);
      return true;
    }
    const bool is_plain = record_ ? draft_.pattern.kind == PatternKind::plain : pigment_.is_plain();
    if (is_plain && next.is(ElementKind::word) && is_colour_word(next.word)) {
      set_colour(read_colour(stream_), next);
      return true;
    }
    if (starts_pattern(context_, next)) {
      context_.fail(next.is(ElementKind::block) ? next.word_span : next.span,
                    "a `pigment` has at most one pattern or colour, before its other items");
    }
    if (!next.is(ElementKind::word) && !next.is(ElementKind::block)) return false;
    // As in POV-Ray, a pigment that was declared with the surface's coordinates is not moved.
    if (is_declared_on_surface_ && read_transform(stream_)) return true;
    open();
    return read_pattern_modifier(stream_, draft_);
  }

  void read_map(const Element& block, bool has_type) {
    PatternedPigment& record = open();
    const PatternKind kind = draft_.pattern.kind;
    const bool is_colours = block.word != word::kw_pigment_map;
    const bool fits = takes_map(kind) && !(is_colours && is_mean(kind));
    if (kind == PatternKind::plain && !has_type) {
      context_.warn(block.word_span, "a map without a pattern before it has no effect");
    } else if (!fits) {
      const std::string what = kind == PatternKind::plain ? "a plain colour" : fmt::format("`{}`", name_of(kind));
      context_.fail(block.word_span, fmt::format("`{}` cannot be used with {}", context_.text(block.word), what));
    }
    record.map = is_colours ? read_colour_map(context_, block) : read_pigment_map(context_, block, entry_value(kind));
  }

  void set_colour(const scene::Colour& colour, const Element& element) {
    const OriginId place = place_of(context_, element);
    if (record_) {
      draft_.pattern.kind = PatternKind::plain;
      draft_.pattern.said_at = place;
      record_->colour = colour;
    } else {
      if (!pigment_.is_plain())
        plain_moved_ = transforms_of(context_, context_.database.pigments[index(pigment_.pattern)].pattern);
      pigment_ = Pigment{.colour = colour, .said_at = place};
    }
  }

  /// The record that this pigment needs once it is more than a colour.
  PatternedPigment& open() {
    if (record_) return *record_;
    record_ = pigment_.is_plain() ? PatternedPigment{.colour = pigment_.colour}
                                  : context_.database.pigments[index(pigment_.pattern)];
    draft_ = draft_of(context_, record_->pattern);
    if (pigment_.is_plain() && plain_moved_ != scene::Transform()) move(context_, draft_, plain_moved_);
    return *record_;
  }

  Pigment close() {
    if (!record_) return pigment_;
    PatternedPigment& record = *record_;
    const PatternKind kind = draft_.pattern.kind;
    if (kind == PatternKind::plain) plain_moved_ = transforms_of(context_, draft_.pattern);
    if (kind == PatternKind::plain && !record.quick_colour)
      return Pigment{.colour = record.colour, .said_at = draft_.pattern.said_at};
    if (is_mean(kind) && record.map == scene::kNoPigmentMap) {
      context_.fail(stream_.span(), "`average` needs a `pigment_map`");
    }
    check_operands(stream_, draft_.pattern);
    if (takes_map(kind) && record.map == scene::kNoPigmentMap)
      record.map = default_pigment_map(context_, draft_.pattern);
    if (kind != PatternKind::plain) record.pattern = std::move(draft_.pattern);
    context_.check_memory(stream_.span(), sizeof(PatternedPigment));
    return with_record(context_, std::move(record));
  }

  ElementStream& stream_;
  Context& context_;
  Pigment pigment_;
  scene::Transform plain_moved_;
  bool is_declared_on_surface_ = false;  ///< the pigment began with a declared one that has `uv_mapping`
  std::optional<PatternedPigment> record_;
  PatternDraft draft_;  ///< of the record's pattern, if there is a record
};

Pigment read_body(ElementStream& stream, const Pigment& base, scene::Transform& plain_moved) {
  PigmentReader reader(stream, base, plain_moved);
  const Pigment pigment = reader.read();
  plain_moved = reader.plain_moved();
  stream.context().check_value_depth(stream.span(), stream.context().depths.of(pigment));
  return pigment;
}

}  // namespace

Pigment read_pigment_body(ElementStream& stream, const Pigment& base) {
  scene::Transform unmoved;
  return read_body(stream, base, unmoved);
}

Pigment read_pigment(Context& context, const Element& block, const Pigment& base) {
  scene::Transform unmoved;
  return read_pigment(context, block, base, unmoved);
}

Pigment read_pigment(Context& context, const Element& block, const Pigment& base, scene::Transform& plain_moved) {
  ElementStream stream(context, block);
  return read_body(stream, base, plain_moved);
}

scene::PigmentId patterned_pigment(Context& context, const Pigment& pigment) {
  if (!pigment.is_plain()) return pigment.pattern;
  return with_record(context, {.colour = pigment.colour}).pattern;
}

Pigment moved(Context& context, const Pigment& pigment, const scene::Transform& transform) {
  if (pigment.is_plain() || transform == scene::Transform()) return pigment;
  PatternedPigment record = context.database.pigments[index(pigment.pattern)];
  if (record.pattern.kind == PatternKind::plain || record.pattern.uv_mapping) return pigment;
  PatternDraft draft = draft_of(context, record.pattern);
  move(context, draft, transform);
  record.pattern = std::move(draft.pattern);
  return with_record(context, std::move(record));
}

}  // namespace isl::interpreter
