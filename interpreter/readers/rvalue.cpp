#include "interpreter/readers/rvalue.h"

#include "interpreter/expressions.h"
#include "interpreter/readers/arguments.h"
#include "interpreter/readers/camera.h"
#include "interpreter/readers/colour.h"
#include "interpreter/readers/objects.h"
#include "interpreter/readers/spline.h"
#include "interpreter/readers/texture.h"
#include "interpreter/readers/transform.h"

#include <fmt/format.h>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

Value read_block(ElementStream& stream) {
  Context& context = stream.context();
  const Element block = stream.peek();
  if (is_object_word(block.word)) {
    stream.drop();
    return {ValueKind::object, read_object(context, block)};
  }
  if (block.word == word::kw_pigment) {
    stream.drop();
    return {ValueKind::pigment,
            make_shared_value<PigmentValue>(read_pigment(context, block, context.default_texture.pigment))};
  }
  if (block.word == word::kw_finish) {
    stream.drop();
    return {ValueKind::finish,
            make_shared_value<FinishValue>(read_finish(context, block, context.default_texture.finish))};
  }
  if (block.word == word::kw_texture) {
    stream.drop();
    return {ValueKind::texture, make_shared_value<TextureValue>(read_texture(context, block, context.default_texture))};
  }
  if (block.word == word::kw_transform) {
    stream.drop();
    return {ValueKind::transform, make_shared_value<TransformValue>(read_transform_block(context, block))};
  }
  if (block.word == word::kw_camera) {
    stream.drop();
    return {ValueKind::camera, read_camera(context, block)};
  }
  if (block.word == word::kw_spline) {
    stream.drop();
    return {ValueKind::spline, make_shared_value<SplineValue>(read_spline(context, block), context.memory)};
  }
  refuse(stream, object_words());
  // Not supported, and reported: an empty object keeps the name usable.
  return {ValueKind::object, make_shared_value<ObjectValue>()};
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
  if (value.kind() != ValueKind::texture) return value;
  while (stream.peek().is_block(word::kw_texture)) {
    const Element layer = stream.take();
    const scene::Texture texture = read_texture(stream.context(), layer, stream.context().default_texture);
    value =
        Value(ValueKind::texture, make_shared_value<TextureValue>(layered(stream.context(), texture, layer.word_span)));
  }
  return value;
}

}  // namespace isl::interpreter
