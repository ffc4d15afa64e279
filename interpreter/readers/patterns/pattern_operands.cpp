#include "interpreter/readers/patterns/pattern_operands.h"

#include "interpreter/functions/functions.h"
#include "interpreter/readers/objects/objects.h"
#include "interpreter/readers/patterns/image.h"
#include "interpreter/readers/textures/pigment.h"
#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <cmath>

namespace isl::interpreter {
namespace {

using scene::Pattern;
namespace word = grammar::word;

constexpr int kMaxArms = 1 << 16;
constexpr int kMaxTiling = 27;

int read_integer_in(ElementStream& stream, std::string_view what, int low, int high) {
  return static_cast<int>(read_number_in(stream, what, low, high));
}

}  // namespace

void begin_agate(ElementStream& /*stream*/, Pattern& pattern) { pattern.operands = scene::AgateOperands{}; }
void begin_brick(ElementStream& /*stream*/, Pattern& pattern) { pattern.operands = scene::BrickOperands{}; }
void begin_crackle(ElementStream& /*stream*/, Pattern& pattern) { pattern.operands = scene::CrackleOperands{}; }
void begin_facets(ElementStream& /*stream*/, Pattern& pattern) { pattern.operands = scene::FacetsOperands{}; }
void begin_pavement(ElementStream& /*stream*/, Pattern& pattern) { pattern.operands = scene::PavementOperands{}; }
void begin_quilted(ElementStream& /*stream*/, Pattern& pattern) { pattern.operands = scene::QuiltedOperands{}; }

void read_density_file(ElementStream& stream, Pattern& pattern) {
  if (!stream.peek().is_word(word::kw_df3)) fail_expected(stream, "`df3` after `density_file`");
  stream.drop();
  pattern.operands = scene::DensityFileOperands{read_file_name(stream, "the name of a file"), 0};
}

void read_gradient(ElementStream& stream, Pattern& pattern) {
  pattern.operands = scene::GradientOperands{read_vector(stream, "a vector after `gradient`").normalized()};
}

void read_image_operand(ElementStream& stream, Pattern& pattern) {
  scene::Image image = read_image_source(stream);
  while (read_image_item(stream, image)) {
  }
  pattern.operands = add_image(stream.context(), std::move(image));
}

// ---- Fractals -------------------------------------------------------------------------------------------------------

namespace {

void read_iterations(ElementStream& stream, scene::FractalOperands& fractal) {
  fractal.iterations = std::floor(read_number_in(stream, "the number of iterations", 0, 4294967295.0));
}

void read_julia_operands(ElementStream& stream, scene::FractalOperands& fractal) {
  fractal.is_julia = true;
  const scene::Vec3 c = read_vector(stream, "a complex number as a vector");
  fractal.real = c.x;
  fractal.imaginary = c.y;
  stream.accept_comma();
  read_iterations(stream, fractal);
}

}  // namespace

void read_mandel(ElementStream& stream, Pattern& pattern) {
  scene::FractalOperands fractal;
  read_iterations(stream, fractal);
  pattern.operands = fractal;
}

void read_julia(ElementStream& stream, Pattern& pattern) {
  scene::FractalOperands fractal;
  read_julia_operands(stream, fractal);
  pattern.operands = fractal;
}

void read_magnet(ElementStream& stream, Pattern& pattern) {
  scene::FractalOperands fractal;
  fractal.magnet = read_integer_in(stream, "the type of a `magnet`", 1, 2);
  if (stream.peek().is_word(word::kw_mandel)) {
    stream.drop();
    read_iterations(stream, fractal);
  } else if (stream.peek().is_word(word::kw_julia)) {
    stream.drop();
    read_julia_operands(stream, fractal);
  } else {
    fail_expected(stream, "`mandel` or `julia` after the type of a `magnet`");
  }
  pattern.operands = fractal;
}

// ---- Patterns of other things ---------------------------------------------------------------------------------------

void read_object_operand(ElementStream& stream, Pattern& pattern) {
  Context& context = stream.context();
  const Ref<ObjectValue> object = read_child(stream);
  if (!object) fail_expected(stream, "an object");
  scene::ObjectOperands operands;
  if (object->object.shape != scene::kNone) {
    operands.object = static_cast<std::uint32_t>(context.database.pattern_objects.size());
    context.database.pattern_objects.push_back(object->object);
  }
  pattern.operands = operands;
}

void read_pigment_operand(ElementStream& stream, Pattern& pattern) {
  const scene::Pigment pigment = read_pigment_body(stream, {});
  pattern.operands = scene::PigmentOperands{patterned_pigment(stream.context(), pigment)};
}

void read_slope(ElementStream& stream, Pattern& pattern) {
  scene::SlopeOperands slope;
  if (stream.peek().is_word(word::kw_point_at)) {
    stream.drop();
    slope.is_reference = true;
  }
  slope.direction = read_vector(stream, "a direction");
  if (!slope.is_reference && slope.direction.length() == 0) {
    stream.context().fail(stream.span(), "the direction of `slope` must not be <0, 0, 0>");
  }
  if (stream.accept_comma() || stream.peek().is(ElementKind::value)) {
    slope.low_slope = read_number(stream, "the low slope");
    stream.accept_comma();
    slope.high_slope = read_number(stream, "the high slope");
  }
  if (stream.peek().is_word(word::kw_altitude)) {
    const SourceSpan span = stream.take().span;
    if (slope.is_reference) stream.context().fail(span, "`altitude` cannot be used with `point_at`");
    slope.has_altitude = true;
    slope.altitude = read_vector(stream, "a vector after `altitude`");
    if (stream.accept_comma() || stream.peek().is(ElementKind::value)) {
      slope.low_altitude = read_number(stream, "the low altitude");
      stream.accept_comma();
      slope.high_altitude = read_number(stream, "the high altitude");
    }
  }
  pattern.operands = slope;
}

void read_spiral(ElementStream& stream, Pattern& pattern) {
  pattern.operands = scene::SpiralOperands{read_integer_in(stream, "the number of arms", -kMaxArms, kMaxArms)};
}

void read_tiling(ElementStream& stream, Pattern& pattern) {
  pattern.operands = scene::TilingOperands{read_integer_in(stream, "the number of a `tiling`", 1, kMaxTiling)};
}

scene::FunctionId read_function_operand(ElementStream& stream) {
  const Element next = stream.take();
  return make_point_function(stream.context(), grammar::as<grammar::Function>(*next.node));
}

}  // namespace isl::interpreter
