#include "interpreter/readers/textures/maps.h"

#include "interpreter/expressions.h"
#include "interpreter/readers/textures/blend_mode.h"
#include "interpreter/readers/textures/default_maps.h"
#include "interpreter/readers/textures/normal.h"
#include "interpreter/readers/textures/pigment.h"
#include "interpreter/readers/textures/texture.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/colour.h"
#include "interpreter/readers/words/said_at.h"
#include "interpreter/records.h"

#include <fmt/format.h>

namespace isl::interpreter {
namespace {

using scene::Colour;
using scene::PigmentMap;
namespace word = grammar::word;

/// The entries of the block, each read by `read_entry` from its own stream into `map`; or the declared map. `blend` is
/// null for maps that have no blend mode.
template <class Declared, class Map, class ReadEntry>
std::optional<decltype(Declared::id)> read_entries(Context& context, const Element& block, ValueKind kind, Map& map,
                                                   ReadEntry read_entry, BlendMode* blend = nullptr) {
  ElementStream stream(context, block);
  if (blend != nullptr) *blend = read_blend_mode(stream);
  const Element first = stream.peek();
  if (first.is(ElementKind::value)) {
    const Value value = stream.take_value();
    if (value.kind() != kind) {
      context.fail(first.span, fmt::format("expected the entries of a `{}` or the name of one, found {}",
                                           context.text(block.word), describe(value)));
    }
    expect_end(stream);
    return value.as<Declared>().id;
  }
  while (!stream.peek().is(ElementKind::end)) {
    if (stream.accept_comma()) continue;
    if (!stream.peek().is(ElementKind::entry)) {
      refuse(stream, {});
      continue;
    }
    const Element entry = stream.take();
    make_room_to_append(context, entry.span, map);
    ElementStream inside(context, entry);
    read_entry(inside, map);
    expect_end(inside);
  }
  if (map.empty()) {
    context.fail(block.word_span, fmt::format("`{}` needs at least one entry", context.text(block.word)));
  }
  context.check_memory(block.span, map.size() * sizeof(map.front()));
  return std::nullopt;
}

/// True if the next element is an expression with a number, not the name of a pigment or of another value.
bool is_number_next(ElementStream& stream) {
  const Element next = stream.peek();
  // A function here is the pattern that the entry's pigment begins with.
  if (!next.is(ElementKind::value) || next.node->kind == grammar::NodeKind::function) return false;
  return !grammar::is_place(*next.node) || evaluate(stream.context(), *next.node).is_numeric();
}

double read_value(ElementStream& stream, EntryValue value) {
  if (value == EntryValue::optional && !is_number_next(stream)) return 1;
  const double number = read_number(stream, "the value of an entry");
  stream.accept_comma();
  return number;
}

/// A colour of an entry, with its place.
scene::Pigment read_entry_colour(ElementStream& stream) {
  const Element next = stream.peek();
  const OriginId place = place_of(stream.context(), next);
  if (!next.is(ElementKind::value)) return {.colour = read_colour(stream), .said_at = place};
  const Value value = stream.take_value();
  const bool is_vector = next.node->kind == grammar::NodeKind::vector;
  if (!value.is_numeric() || is_vector) {
    stream.context().fail(next.span, fmt::format("expected a colour, found {}", describe(value)),
                          is_vector ? "write `rgb` before it" : "");
  }
  return {.colour = to_colour(read_colour_after(stream, value)), .said_at = place};
}

/// `[v colour]`, or POV-Ray 1's `[v1, v2 color A color B]`.
void read_colour_entry(ElementStream& stream, PigmentMap& map) {
  const double value = read_value(stream, EntryValue::needed);
  std::optional<double> second;
  const Element next = stream.peek();
  if (next.is(ElementKind::value) && next.node->kind != grammar::NodeKind::vector) {
    const Value found = stream.take_value();
    if (!found.is_number()) {
      if (!found.is_numeric()) {
        stream.context().fail(next.span, fmt::format("expected a colour, found {}", describe(found)));
      }
      const OriginId place = place_of(stream.context(), next);
      map.push_back({value, {.colour = to_colour(read_colour_after(stream, found)), .said_at = place}});
      return;
    }
    second = found.number();
    stream.accept_comma();
  }
  map.push_back({value, read_entry_colour(stream)});
  if (!second) return;
  stream.accept_comma();
  map.push_back({*second, read_entry_colour(stream)});
}

void read_pigment_entry(ElementStream& stream, PigmentMap& map, EntryValue kind) {
  const double value = read_value(stream, kind);
  map.push_back({value, read_pigment_body(stream, stream.context().default_texture.pigment)});
}

void read_normal_entry(ElementStream& stream, scene::NormalMap& map, EntryValue kind) {
  const double value = read_value(stream, kind);
  map.push_back({value, read_normal_body(stream, stream.context().default_texture.normal)});
}

void read_texture_entry(ElementStream& stream, scene::TextureMap& map, EntryValue kind) {
  const double value = read_value(stream, kind);
  const scene::Texture texture = read_texture_body(stream, stream.context().default_texture);
  map.push_back({value, texture_id(stream.context(), texture)});
}

void read_slope_entry(ElementStream& stream, scene::SlopeMap& map) {
  const double value = read_value(stream, EntryValue::needed);
  const scene::Vec3 shape = read_vector(stream, "<height, slope>");
  map.push_back({value, shape.x, shape.y});
}

}  // namespace

scene::PigmentMapId read_colour_map(Context& context, const Element& block) {
  PigmentMap map;
  BlendMode blend;
  const auto declared =
      read_entries<PigmentMapValue>(context, block, ValueKind::colour_map, map, read_colour_entry, &blend);
  if (!declared) apply_blend_mode(context, block, blend, map);
  return declared ? *declared : add_map<scene::PigmentMapId>(context, context.database.pigment_maps, std::move(map));
}

scene::PigmentMapId read_pigment_map(Context& context, const Element& block, EntryValue value) {
  PigmentMap map;
  BlendMode blend;
  const auto declared = read_entries<PigmentMapValue>(
      context, block, ValueKind::pigment_map, map,
      [value](ElementStream& stream, auto& entries) { read_pigment_entry(stream, entries, value); }, &blend);
  if (!declared) apply_blend_mode(context, block, blend, map);
  return declared ? *declared : add_map<scene::PigmentMapId>(context, context.database.pigment_maps, std::move(map));
}

scene::NormalMapId read_normal_map(Context& context, const Element& block, EntryValue value) {
  scene::NormalMap map;
  const auto declared = read_entries<NormalMapValue>(
      context, block, ValueKind::normal_map, map,
      [value](ElementStream& stream, auto& entries) { read_normal_entry(stream, entries, value); });
  return declared ? *declared : add_map<scene::NormalMapId>(context, context.database.normal_maps, std::move(map));
}

scene::SlopeMapId read_slope_map(Context& context, const Element& block) {
  scene::SlopeMap map;
  const auto declared = read_entries<SlopeMapValue>(context, block, ValueKind::slope_map, map, read_slope_entry);
  return declared ? *declared : add_map<scene::SlopeMapId>(context, context.database.slope_maps, std::move(map));
}

scene::TextureMapId read_texture_map(Context& context, const Element& block, EntryValue value) {
  scene::TextureMap map;
  const auto declared = read_entries<TextureMapValue>(
      context, block, ValueKind::texture_map, map,
      [value](ElementStream& stream, auto& entries) { read_texture_entry(stream, entries, value); });
  return declared ? *declared : add_map<scene::TextureMapId>(context, context.database.texture_maps, std::move(map));
}

// ---- Lists ----------------------------------------------------------------------------------------------------------

namespace {

/// Reads one item of a pigment's list; returns false if the next element is none.
bool read_pigment_item(ElementStream& stream, scene::Pigment& pigment) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (next.is_block(word::kw_pigment)) {
    stream.drop();
    pigment = read_pigment(context, next, context.default_texture.pigment);
    return true;
  }
  const bool is_colour = next.is(ElementKind::value) || (next.is(ElementKind::word) && is_colour_word(next.word));
  if (!is_colour) return false;
  pigment = {read_colour(stream)};
  return true;
}

/// Reads items until one is missing, `count` are read, or nothing follows; commas between them are optional.
template <class ReadItem>
int read_items(ElementStream& stream, int count, ReadItem read_item) {
  int i = 0;
  while (i < count && read_item(i)) {
    ++i;
    stream.accept_comma();
  }
  return i;
}

}  // namespace

scene::PigmentMapId read_pigment_list(ElementStream& stream, scene::PatternKind kind, int count) {
  Context& context = stream.context();
  PigmentMap list = default_pigment_list(kind);
  ISL_CHECK(static_cast<int>(list.size()) == count, "{} default colours for {} items", list.size(), count);
  // As in POV-Ray, what is missing behind a colour is the pattern's own, and behind a pigment the default pigment.
  if (stream.peek().is_block(word::kw_pigment)) {
    for (auto& entry : list) entry.pigment = context.default_texture.pigment;
  }
  const int read = read_items(
      stream, count, [&](int i) { return read_pigment_item(stream, list[static_cast<std::size_t>(i)].pigment); });
  if (read == 0) return default_pigment_list_id(context, kind);
  return add_map<scene::PigmentMapId>(context, context.database.pigment_maps, std::move(list));
}

scene::NormalMapId read_normal_list(ElementStream& stream, int count) {
  Context& context = stream.context();
  scene::NormalMap list;
  for (int i = 0; i < count; ++i) list.push_back({static_cast<double>(i), context.default_texture.normal});
  const int read = read_items(stream, count, [&](int i) {
    if (!stream.peek().is_block(word::kw_normal)) return false;
    const Element block = stream.take();
    list[static_cast<std::size_t>(i)].normal = read_normal(context, block, context.default_texture.normal);
    return true;
  });
  if (read == 0) return scene::kNoNormalMap;
  return add_map<scene::NormalMapId>(context, context.database.normal_maps, std::move(list));
}

scene::TextureMapId read_texture_list(ElementStream& stream, int count) {
  Context& context = stream.context();
  scene::TextureMap list;
  const scene::TextureId default_id = texture_id(context, context.default_texture);
  for (int i = 0; i < count; ++i) list.push_back({static_cast<double>(i), default_id});
  static_cast<void>(read_items(stream, count, [&](int i) {
    if (!stream.peek().is_block(word::kw_texture)) return false;
    const Element block = stream.take();
    const scene::Texture texture = read_texture(context, block, context.default_texture);
    list[static_cast<std::size_t>(i)].texture = texture_id(context, texture);
    return true;
  }));
  return add_map<scene::TextureMapId>(context, context.database.texture_maps, std::move(list));
}

}  // namespace isl::interpreter
