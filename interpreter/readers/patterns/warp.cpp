#include "interpreter/readers/patterns/warp.h"

#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::interpreter {
namespace {

using scene::BlackHoleWarp;
using scene::MappingWarp;
using scene::RepeatWarp;
using scene::Vec3;
namespace word = grammar::word;

/// POV-Ray clamps the number of octaves to this range.
constexpr double kFewestOctaves = 1, kMostOctaves = 10;

RepeatWarp read_repeat(ElementStream& stream) {
  Context& context = stream.context();
  RepeatWarp warp;
  const SourceSpan span = stream.peek().span;
  const Vec3 direction = read_vector(stream, "a vector along an axis after `repeat`");
  int axes = 0;
  for (int i = 0; i < 3; ++i) {
    if (direction[i] == 0) continue;
    ++axes;
    warp.axis = i;
    warp.width = direction[i];
  }
  if (axes != 1) {
    context.fail(span, fmt::format("expected a vector along one axis after `repeat`, found <{:g}, {:g}, {:g}>",
                                   direction.x, direction.y, direction.z));
  }
  while (true) {
    if (stream.peek().is_word(word::kw_offset)) {
      stream.drop();
      warp.offset = read_vector(stream, "a vector after `offset`");
    } else if (stream.peek().is_word(word::kw_flip)) {
      stream.drop();
      const Vec3 flip = read_vector(stream, "a vector after `flip`");
      for (int i = 0; i < 3; ++i) warp.flip[i] = flip[i] != 0 ? 1 : 0;
    } else {
      return warp;
    }
  }
}

BlackHoleWarp read_black_hole(ElementStream& stream) {
  BlackHoleWarp warp;
  warp.centre = read_vector(stream, "the centre of the `black_hole`");
  stream.accept_comma();
  warp.radius = read_number(stream, "a radius");
  while (stream.peek().is(ElementKind::word)) {
    switch (static_cast<word::Index>(stream.peek().word)) {
      case word::kIndex_strength:
        stream.drop();
        warp.strength = read_number(stream, "a number after `strength`");
        break;
      case word::kIndex_falloff:
        stream.drop();
        warp.falloff = read_number(stream, "a number after `falloff`");
        break;
      case word::kIndex_inverse:
        stream.drop();
        warp.inverse = true;
        break;
      case word::kIndex_repeat:
        stream.drop();
        warp.repeats = true;
        warp.repeat = read_vector(stream, "a vector after `repeat`");
        break;
      case word::kIndex_turbulence:
        stream.drop();
        warp.is_turbulent = true;
        warp.turbulence = read_vector(stream, "a vector after `turbulence`");
        break;
      default: return warp;
    }
  }
  return warp;
}

MappingWarp read_mapping(ElementStream& stream, MappingWarp::Shape shape) {
  MappingWarp warp{.shape = shape};
  if (shape == MappingWarp::Shape::plane && stream.peek().is(ElementKind::value)) {
    warp.orientation = read_vector(stream, "the normal of the plane");
    stream.accept_comma();
    warp.distance = read_number(stream, "the distance of the plane");
  }
  const bool is_round = shape <= MappingWarp::Shape::torus;
  while (is_round) {
    if (stream.peek().is_word(word::kw_orientation)) {
      stream.drop();
      warp.orientation = read_vector(stream, "a vector after `orientation`");
    } else if (stream.peek().is_word(word::kw_dist_exp)) {
      stream.drop();
      warp.distance_exponent = read_number(stream, "a number after `dist_exp`");
    } else if (shape == MappingWarp::Shape::torus && stream.peek().is_word(word::kw_major_radius)) {
      stream.drop();
      warp.major_radius = read_number(stream, "a number after `major_radius`");
    } else {
      break;
    }
  }
  return warp;
}

scene::Turbulence read_turbulence(ElementStream& stream) {
  scene::Turbulence turbulence;
  turbulence.amount = read_vector(stream, "a vector or number after `turbulence`");
  while (stream.peek().is(ElementKind::word) && read_turbulence_item(stream, turbulence)) {
  }
  return turbulence;
}

struct WarpRow {
  grammar::Symbol word;
  scene::Warp (*read)(ElementStream&);
};

template <MappingWarp::Shape shape>
scene::Warp read_mapping_as(ElementStream& stream) {
  return read_mapping(stream, shape);
}

constexpr WarpRow kWarps[] = {
    {word::kw_repeat, [](ElementStream& s) -> scene::Warp { return read_repeat(s); }},
    {word::kw_black_hole, [](ElementStream& s) -> scene::Warp { return read_black_hole(s); }},
    {word::kw_turbulence, [](ElementStream& s) -> scene::Warp { return read_turbulence(s); }},
    {word::kw_cylindrical, read_mapping_as<MappingWarp::Shape::cylinder>},
    {word::kw_spherical, read_mapping_as<MappingWarp::Shape::sphere>},
    {word::kw_toroidal, read_mapping_as<MappingWarp::Shape::torus>},
    {word::kw_planar, read_mapping_as<MappingWarp::Shape::plane>},
    {word::kw_cubic, read_mapping_as<MappingWarp::Shape::cube>},
};

}  // namespace

scene::Warp read_warp(Context& context, const Element& block) {
  ElementStream stream(context, block);
  const Element next = stream.peek();
  const auto* const row = std::ranges::find(kWarps, next.word, &WarpRow::word);
  if (!next.is(ElementKind::word) || row == std::end(kWarps)) fail_expected(stream, "a kind of `warp`");
  stream.drop();
  scene::Warp warp = row->read(stream);
  expect_end(stream);
  return warp;
}

bool read_turbulence_item(ElementStream& stream, scene::Turbulence& turbulence) {
  switch (static_cast<word::Index>(stream.peek().word)) {
    case word::kIndex_turbulence:
      stream.drop();
      turbulence.amount = read_vector(stream, "a vector or number after `turbulence`");
      return true;
    case word::kIndex_octaves:
      stream.drop();
      turbulence.octaves =
          static_cast<int>(std::clamp(read_number(stream, "a number after `octaves`"), kFewestOctaves, kMostOctaves));
      return true;
    case word::kIndex_omega:
      stream.drop();
      turbulence.omega = read_number(stream, "a number after `omega`");
      return true;
    case word::kIndex_lambda:
      stream.drop();
      turbulence.lambda = read_number(stream, "a number after `lambda`");
      return true;
    default: return false;
  }
}

}  // namespace isl::interpreter
