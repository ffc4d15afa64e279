#include "interpreter/readers/textures/texture.h"

#include "interpreter/readers/patterns/image.h"
#include "interpreter/readers/patterns/pattern.h"
#include "interpreter/readers/patterns/pattern_operands.h"
#include "interpreter/readers/textures/finish.h"
#include "interpreter/readers/textures/maps.h"
#include "interpreter/readers/textures/normal.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/transform.h"
#include "interpreter/records.h"

#include <fmt/format.h>

namespace isl::interpreter {
namespace {

using scene::PatternKind;
using scene::Texture;
using scene::TexturePattern;
namespace word = grammar::word;

constexpr grammar::Symbol kTextureWords[] = {word::kw_pigment, word::kw_normal, word::kw_finish,   word::kw_texture_map,
                                             word::kw_scale,   word::kw_rotate, word::kw_translate};

Texture with_pattern(Context& context, TexturePattern&& record) {
  return {.pattern =
              add_record<scene::TexturePatternId>(context, context.database.texture_patterns, std::move(record))};
}

class TextureReader {
 public:
  TextureReader(ElementStream& stream, const Texture& base)
      : stream_(stream), context_(stream.context()), texture_(base) {}

  Texture read() {
    bool uv_mapping = accept_uv_mapping();
    const bool is_named = read_identifiers();
    uv_mapping = uv_mapping || accept_uv_mapping();
    if (!is_named && read_patterned()) {
      if (uv_mapping) draft_.pattern.uv_mapping = true;
      return close_pattern();
    }
    while (!stream_.peek().is(ElementKind::end)) {
      if (!read_item()) refuse(stream_, kTextureWords);
    }
    if (no_bump_scale_) texture_ = without_bump_scale(context_, texture_);
    return uv_mapping ? uv_mapped(context_, texture_) : texture_;
  }

  /// How the pigment was moved while it was a plain colour.
  [[nodiscard]] const scene::Transform& plain_moved() const { return plain_moved_; }

 private:
  bool accept_uv_mapping() {
    const bool is_next = stream_.peek().is_word(word::kw_uv_mapping);
    if (is_next) stream_.drop();
    return is_next;
  }

  /// `texture { Texture Pigment Normal Finish … }`: each declared value replaces that of the base.
  bool read_identifiers() {
    bool is_texture = false;
    while (stream_.peek().is(ElementKind::value) && !starts_pattern(context_, stream_.peek())) {
      const SourceSpan span = stream_.peek().span;
      const Value value = stream_.take_value();
      switch (value.kind()) {
        case ValueKind::texture:
          texture_ = value.as<TextureValue>().texture;
          plain_moved_ = value.as<TextureValue>().plain_moved;
          texture_.named_at = context_.origin(span);
          is_texture = true;
          break;
        case ValueKind::pigment:
          texture_.pigment = value.as<PigmentValue>().pigment;
          plain_moved_ = value.as<PigmentValue>().plain_moved;
          break;
        case ValueKind::normal: texture_.normal = value.as<NormalValue>().id; break;
        case ValueKind::finish: {
          scene::Finish finish = value.as<FinishValue>().finish;
          finish.named_at = context_.origin(span);
          texture_.finish = finish_id(context_, finish);
          break;
        }
        default: context_.fail(span, fmt::format("expected a texture or its items, found {}", describe(value)));
      }
    }
    return is_texture;
  }

  bool read_item() {
    const Element next = stream_.peek();
    if (next.is_block(word::kw_pigment) || next.is_block(word::kw_normal) || next.is_block(word::kw_finish)) {
      check_plain(next);
      stream_.drop();
      if (next.word == word::kw_pigment)
        texture_.pigment = read_pigment(context_, next, texture_.pigment, plain_moved_);
      if (next.word == word::kw_normal) texture_.normal = read_normal(context_, next, texture_.normal);
      if (next.word == word::kw_finish)
        texture_.finish = finish_id(context_, read_finish(context_, next, finish_of(context_, texture_)));
      return true;
    }
    if (next.is_word(word::kw_no_bump_scale)) {
      stream_.drop();
      return no_bump_scale_ = true;
    }
    if (starts_pattern(context_, next)) {
      context_.fail(next.is(ElementKind::block) ? next.word_span : next.span,
                    "put the pattern of a `texture` first, before its other items");
    }
    const std::optional<scene::Transform> transform = read_transform(stream_);
    if (!transform) return false;
    texture_ = moved(context_, texture_, *transform);
    plain_moved_ = scene::then(plain_moved_, *transform);
    return true;
  }

  /// A texture that a pattern chooses has no pigment, normal or finish of its own.
  void check_plain(const Element& block) {
    if (texture_.pattern == scene::kNoTexturePattern) return;
    context_.fail(block.word_span,
                  fmt::format("`{}` cannot be used with a texture that has a pattern", context_.text(block.word)));
  }

  // ---- Textures with a pattern --------------------------------------------------------------------------------------

  /// Reads the pattern with its list or map and modifiers, to the end; returns false if there is none.
  bool read_patterned() {
    const Element next = stream_.peek();
    if (next.is_block(word::kw_tiles)) {
      stream_.drop();
      read_tiles(next);
    } else if (next.is_block(word::kw_material_map)) {
      stream_.drop();
      read_material_map(next);
    } else if (starts_pattern(context_, next)) {
      const ReadList read_list = [this](ElementStream& stream, PatternKind /*kind*/, int count) {
        map_ = read_texture_list(stream, count);
      };
      static_cast<void>(read_pattern(stream_, draft_, PatternHost::texture, read_list));
    } else {
      return false;
    }
    while (!stream_.peek().is(ElementKind::end)) read_modifier();
    return true;
  }

  void read_modifier() {
    const Element next = stream_.peek();
    if (next.is_block(word::kw_texture_map)) {
      stream_.drop();
      if (const PatternKind kind = draft_.pattern.kind;
          kind != PatternKind::plain && !render::info_of(kind).takes_map()) {
        context_.fail(next.word_span,
                      fmt::format("`texture_map` cannot be used with `{}`", name_of(draft_.pattern.kind)));
      }
      map_ = read_texture_map(context_, next, entry_value(draft_.pattern.kind));
    } else if (next.is_word(word::kw_no_bump_scale)) {
      stream_.drop();  // the pattern does not scale bumps; its textures decide that themselves
    } else if (!read_pattern_modifier(stream_, draft_)) {
      static constexpr grammar::Symbol kItems[] = {word::kw_texture_map, word::kw_turbulence, word::kw_scale,
                                                   word::kw_rotate, word::kw_translate};
      refuse(stream_, kItems);
    }
  }

  /// `tiles { texture {} tile2 texture {} }` of POV-Ray 1: a checker that begins with the second one.
  void read_tiles(const Element& block) {
    ElementStream stream(context_, block);
    const scene::TextureId first = read_list_texture(stream);
    if (!stream.peek().is_word(word::kw_tile2)) fail_expected(stream, "`tile2`");
    stream.drop();
    scene::TextureMap list{{0, read_list_texture(stream)}, {1, first}};
    expect_end(stream);
    set_kind(draft_, PatternKind::checker);
    map_ = add_map<scene::TextureMapId>(context_, context_.database.texture_maps, std::move(list));
  }

  void read_material_map(const Element& block) {
    ElementStream stream(context_, block);
    scene::Image image = read_image_source(stream);
    image.holds_numbers = true;
    while (read_image_item(stream, image)) {
    }
    scene::TextureMap list;
    do {
      list.push_back({static_cast<double>(list.size()), read_list_texture(stream)});
    } while (!stream.peek().is(ElementKind::end));
    set_kind(draft_, PatternKind::material_map);
    image.choices = static_cast<int>(list.size());
    draft_.pattern.operands = add_image(context_, std::move(image));
    map_ = add_map<scene::TextureMapId>(context_, context_.database.texture_maps, std::move(list));
  }

  scene::TextureId read_list_texture(ElementStream& stream) {
    if (!stream.peek().is_block(word::kw_texture)) fail_expected(stream, "a `texture`");
    const Element block = stream.take();
    return texture_id(context_, read_texture(context_, block, context_.default_texture));
  }

  Texture close_pattern() {
    if (map_ == scene::kNoTextureMap) {
      context_.fail(stream_.span(),
                    fmt::format("`{}` in a texture needs a `texture_map`", name_of(draft_.pattern.kind)));
    }
    check_operands(stream_, draft_.pattern);
    context_.check_memory(stream_.span(), sizeof(TexturePattern));
    return with_pattern(context_, {std::move(draft_.pattern), map_});
  }

  ElementStream& stream_;
  Context& context_;
  Texture texture_;
  scene::Transform plain_moved_;
  bool no_bump_scale_ = false;
  PatternDraft draft_{{}, stream_.context().database.transforms.size()};
  scene::TextureMapId map_ = scene::kNoTextureMap;
};

Texture read_body(ElementStream& stream, const Texture& base, scene::Transform& plain_moved) {
  TextureReader reader(stream, base);
  const Texture texture = reader.read();
  plain_moved = reader.plain_moved();
  stream.context().check_value_depth(stream.span(), stream.context().depths.of(texture));
  return texture;
}

}  // namespace

Texture read_texture_body(ElementStream& stream, const Texture& base) {
  scene::Transform plain_moved;
  return read_body(stream, base, plain_moved);
}

Texture read_texture(Context& context, const Element& block, const Texture& base) {
  scene::Transform plain_moved;
  return read_texture(context, block, base, plain_moved);
}

Texture read_texture(Context& context, const Element& block, const Texture& base, scene::Transform& plain_moved) {
  ElementStream stream(context, block);
  return read_body(stream, base, plain_moved);
}

}  // namespace isl::interpreter
