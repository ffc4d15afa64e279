#include "interpreter/readers/words/rvalue.h"

#include "interpreter/expressions.h"
#include "interpreter/readers/objects/objects.h"
#include "interpreter/readers/textures/finish.h"
#include "interpreter/readers/textures/interior.h"
#include "interpreter/readers/textures/maps.h"
#include "interpreter/readers/textures/normal.h"
#include "interpreter/readers/textures/pigment.h"
#include "interpreter/readers/textures/surface.h"
#include "interpreter/readers/textures/texture.h"
#include "interpreter/readers/view/camera.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/colour.h"
#include "interpreter/readers/words/spline.h"
#include "interpreter/readers/words/transform.h"
#include "interpreter/readers/world/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

/// A block that makes a value, other than an object.
struct BlockRow {
  grammar::Symbol word;
  Value (*read)(Context&, const Element&);
};

Value pigment_value(Context& context, const Element& block) {
  scene::Transform plain_moved;
  const scene::Pigment pigment = read_pigment(context, block, context.default_texture.pigment, plain_moved);
  return {ValueKind::pigment, make_shared_value<PigmentValue>(pigment, plain_moved)};
}

Value normal_value(Context& context, const Element& block) {
  const scene::NormalId normal = read_normal(context, block, context.default_texture.normal);
  return {ValueKind::normal, make_shared_value<NormalValue>(normal)};
}

Value finish_value(Context& context, const Element& block) {
  const scene::Finish finish = read_finish(context, block, finish_of(context, context.default_texture));
  return {ValueKind::finish, make_shared_value<FinishValue>(finish)};
}

Value texture_value(Context& context, const Element& block) {
  scene::Transform plain_moved;
  const scene::Texture texture = read_texture(context, block, context.default_texture, plain_moved);
  return {ValueKind::texture, make_shared_value<TextureValue>(texture, plain_moved)};
}

Value material_value(Context& context, const Element& block) {
  return {ValueKind::material, make_shared_value<MaterialValue>(read_material(context, block))};
}

Value interior_value(Context& context, const Element& block) {
  return {ValueKind::interior, make_shared_value<InteriorValue>(read_interior(context, block))};
}

Value colour_map_value(Context& context, const Element& block) {
  return {ValueKind::colour_map, make_shared_value<PigmentMapValue>(read_colour_map(context, block))};
}

Value pigment_map_value(Context& context, const Element& block) {
  return {ValueKind::pigment_map,
          make_shared_value<PigmentMapValue>(read_pigment_map(context, block, EntryValue::needed))};
}

Value normal_map_value(Context& context, const Element& block) {
  return {ValueKind::normal_map,
          make_shared_value<NormalMapValue>(read_normal_map(context, block, EntryValue::needed))};
}

Value slope_map_value(Context& context, const Element& block) {
  return {ValueKind::slope_map, make_shared_value<SlopeMapValue>(read_slope_map(context, block))};
}

Value texture_map_value(Context& context, const Element& block) {
  return {ValueKind::texture_map,
          make_shared_value<TextureMapValue>(read_texture_map(context, block, EntryValue::needed))};
}

Value transform_value(Context& context, const Element& block) {
  return {ValueKind::transform, make_shared_value<TransformValue>(read_transform_block(context, block))};
}

Value camera_value(Context& context, const Element& block) { return {ValueKind::camera, read_camera(context, block)}; }

constexpr BlockRow kBlocks[] = {
    {word::kw_pigment, pigment_value},         {word::kw_normal, normal_value},
    {word::kw_finish, finish_value},           {word::kw_texture, texture_value},
    {word::kw_material, material_value},       {word::kw_interior, interior_value},
    {word::kw_color_map, colour_map_value},    {word::kw_colour_map, colour_map_value},
    {word::kw_pigment_map, pigment_map_value}, {word::kw_normal_map, normal_map_value},
    {word::kw_slope_map, slope_map_value},     {word::kw_texture_map, texture_map_value},
    {word::kw_transform, transform_value},     {word::kw_camera, camera_value},
};

Value read_block(ElementStream& stream) {
  Context& context = stream.context();
  const Element block = stream.peek();
  if (is_object_word(block.word)) {
    stream.drop();
    return {ValueKind::object, read_object(context, block)};
  }
  if (const auto* const row = std::ranges::find(kBlocks, block.word, &BlockRow::word); row != std::end(kBlocks)) {
    stream.drop();
    return row->read(context, block);
  }
  if (statement_kind(context, block.word)) {
    stream.drop();
    return {ValueKind::statement, make_shared_value<StatementValue>(read_statement(context, block))};
  }
  if (block.word == word::kw_spline) {
    stream.drop();
    return {ValueKind::spline, make_shared_value<SplineValue>(read_spline(context, block), context.memory)};
  }
  refuse(stream, object_words());
  // Unsupported, and reported: an empty object keeps the name usable.
  return {ValueKind::object, empty_object(stream)};
}

}  // namespace

Value read_rvalue_after(ElementStream& stream, Value first) {
  const Element& next = stream.peek();
  if (first.is_numeric() && is_colour_component(next)) return read_colour_after(stream, first);
  return first;
}

Value read_rvalue(ElementStream& stream) {
  const Element& next = stream.peek();
  if (next.is(ElementKind::value)) {
    Value value = stream.take_value();
    return read_rvalue_after(stream, std::move(value));
  }
  if (next.is(ElementKind::word) && is_colour_word(next.word)) return to_value(read_colour(stream));
  if (next.is(ElementKind::word) && next.word == word::kw_transform) {
    return {ValueKind::transform, make_shared_value<TransformValue>(*read_transform(stream))};
  }
  if (next.is(ElementKind::block)) return read_block(stream);
  fail_expected(stream, "a value");
}

Value read_declared(ElementStream& stream) {
  Value value = read_rvalue(stream);
  return value.kind() == ValueKind::texture ? with_layers(stream, std::move(value)) : value;
}

Value with_layers(ElementStream& stream, Value value) {
  Context& context = stream.context();
  while (stream.peek().is_block(word::kw_texture)) {
    const Element layer = stream.take();
    scene::Transform plain_moved;
    const scene::Texture top = read_texture(context, layer, context.default_texture, plain_moved);
    const scene::Texture texture = layered(context, value.as<TextureValue>().texture, top, layer.word_span);
    value = Value(ValueKind::texture, make_shared_value<TextureValue>(texture, plain_moved));
  }
  return value;
}

}  // namespace isl::interpreter
