#include "interpreter/readers/textures/normal.h"

#include "interpreter/readers/patterns/image.h"
#include "interpreter/readers/patterns/pattern.h"
#include "interpreter/readers/patterns/pattern_operands.h"
#include "interpreter/readers/textures/maps.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/records.h"

#include <fmt/format.h>

namespace isl::interpreter {
namespace {

using render::info_of;
using scene::Normal;
using scene::NormalId;
using scene::PatternKind;
namespace word = grammar::word;

constexpr grammar::Symbol kNormalWords[] = {word::kw_bump_size,  word::kw_bumps,        word::kw_bump_map,
                                            word::kw_normal_map, word::kw_slope_map,    word::kw_scale,
                                            word::kw_rotate,     word::kw_translate,    word::kw_turbulence,
                                            word::kw_accuracy,   word::kw_no_bump_scale};

NormalId add_normal(Context& context, Normal&& normal) {
  return add_record<NormalId>(context, context.database.normals, std::move(normal));
}

class NormalReader {
 public:
  NormalReader(ElementStream& stream, NormalId base) : stream_(stream), context_(stream.context()) { load(base); }

  NormalId read() {
    read_identifier();
    if (stream_.peek().is_word(word::kw_uv_mapping)) {
      stream_.drop();
      draft_.pattern.uv_mapping = true;
      read_identifier();
    }
    if (starts_pattern(context_, stream_.peek())) read_type();
    while (!stream_.peek().is(ElementKind::end)) {
      if (!read_modifier()) refuse(stream_, kNormalWords);
    }
    if (draft_.pattern.kind == PatternKind::plain) {
      // Without a pattern it is flat, but as a default it hands its sizes on to normals with one.
      const Normal flat;
      const bool has_sizes = normal_.bump_size != flat.bump_size || normal_.accuracy != flat.accuracy;
      if (!has_sizes) {
        context_.warn(stream_.span(), "a `normal` without a pattern is flat");
        return scene::kNoNormal;
      }
    }
    if (info_of(draft_.pattern.kind).choice == render::PatternChoice::mean_of_map &&
        normal_.map == scene::kNoNormalMap) {
      context_.fail(stream_.span(), "`average` needs a `normal_map`");
    }
    check_operands(stream_, draft_.pattern);
    normal_.pattern = std::move(draft_.pattern);
    context_.check_memory(stream_.span(), sizeof(Normal));
    return add_normal(context_, std::move(normal_));
  }

 private:
  void load(NormalId id) {
    if (id != scene::kNoNormal) normal_ = context_.database.normals[index(id)];
    const bool uv_mapping = draft_.pattern.uv_mapping;
    draft_ = draft_of(context_, normal_.pattern);
    draft_.pattern.uv_mapping |= uv_mapping;
  }

  void read_identifier() {
    const Element first = stream_.peek();
    if (!first.is(ElementKind::value) || first.node->kind == grammar::NodeKind::function) return;
    const Value value = stream_.take_value();
    if (value.kind() != ValueKind::normal)
      context_.fail(first.span, fmt::format("expected a normal or a pattern, found {}", describe(value)));
    load(value.as<NormalValue>().id);
    read_size();
  }

  void read_type() {
    const bool had_list = list_length(draft_.pattern.kind) > 0;
    scene::NormalMapId list = scene::kNoNormalMap;
    const Element type = stream_.peek();
    const ReadList read_list = [&](ElementStream& stream, PatternKind /*kind*/, int count) {
      list = read_normal_list(stream, count);
    };
    static_cast<void>(read_pattern(stream_, draft_, PatternHost::normal, read_list));
    if (had_list || list_length(draft_.pattern.kind) > 0) normal_.map = list;
    if (info_of(draft_.pattern.kind).block == render::PatternBlock::of_host) read_bump_map(type);
    read_size();
  }

  /// The size of the bumps may follow the pattern, with or without a comma. As in POV-Ray, a comma alone means nothing.
  void read_size() {
    stream_.accept_comma();
    if (stream_.peek().is(ElementKind::value)) {
      normal_.bump_size = read_number(stream_, "the size of the bumps");
    }
  }

  void read_bump_map(const Element& block) {
    ElementStream stream(context_, block);
    scene::Image image = read_image_source(stream);
    image.holds_numbers = true;
    while (!stream.peek().is(ElementKind::end)) {
      if (read_image_item(stream, image)) continue;
      if (stream.peek().is_word(word::kw_bump_size)) {
        stream.drop();
        normal_.bump_size = read_number(stream, "a number after `bump_size`");
      } else {
        refuse(stream, kNormalWords);
      }
    }
    draft_.pattern.operands = add_image(context_, std::move(image));
  }

  bool read_modifier() {
    const Element next = stream_.peek();
    if (next.is_block(word::kw_normal_map)) {
      stream_.drop();
      check_map(next);
      normal_.map = read_normal_map(context_, next, entry_value(draft_.pattern.kind));
      return true;
    }
    if (next.is_block(word::kw_slope_map)) {
      stream_.drop();
      check_map(next);
      normal_.slope_map = read_slope_map(context_, next);
      return true;
    }
    if (next.is_word(word::kw_no_bump_scale)) {
      stream_.drop();
      normal_.no_bump_scale = true;
      return true;
    }
    if (next.is_word(word::kw_bump_size) || next.is_word(word::kw_accuracy)) {
      stream_.drop();
      double& value = next.word == word::kw_accuracy ? normal_.accuracy : normal_.bump_size;
      value = read_number(stream_, fmt::format("a number after `{}`", context_.text(next.word)));
      return true;
    }
    if (starts_pattern(context_, next)) {
      context_.fail(next.is(ElementKind::block) ? next.word_span : next.span,
                    "a `normal` has at most one pattern, before its other items");
    }
    return read_pattern_modifier(stream_, draft_);
  }

  void check_map(const Element& block) {
    const PatternKind kind = draft_.pattern.kind;
    if (info_of(kind).takes_map()) return;
    context_.fail(block.word_span,
                  fmt::format("`{}` cannot be used with `{}`", context_.text(block.word), name_of(kind)));
  }

  ElementStream& stream_;
  Context& context_;
  Normal normal_;
  PatternDraft draft_;
};

}  // namespace

NormalId read_normal_body(ElementStream& stream, NormalId base) {
  const NormalId normal = NormalReader(stream, base).read();
  stream.context().check_value_depth(stream.span(), stream.context().depths.of(normal));
  return normal;
}

NormalId read_normal(Context& context, const Element& block, NormalId base) {
  ElementStream stream(context, block);
  return read_normal_body(stream, base);
}

NormalId moved(Context& context, NormalId id, const scene::Transform& transform) {
  if (id == scene::kNoNormal || transform == scene::Transform()) return id;
  Normal normal = context.database.normals[index(id)];
  if (normal.pattern.uv_mapping) return id;
  PatternDraft draft = draft_of(context, normal.pattern);
  move(context, draft, transform);
  normal.pattern = std::move(draft.pattern);
  return add_normal(context, std::move(normal));
}

NormalId without_bump_scale(Context& context, NormalId id) {
  if (id == scene::kNoNormal || context.database.normals[index(id)].no_bump_scale) return id;
  Normal normal = context.database.normals[index(id)];
  normal.no_bump_scale = true;
  return add_normal(context, std::move(normal));
}

}  // namespace isl::interpreter
