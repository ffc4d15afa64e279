#include "interpreter/readers/patterns/image.h"

#include "interpreter/expressions.h"
#include "interpreter/readers/patterns/pattern_operands.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/records.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::interpreter {
namespace {

using scene::Image;
using scene::ImageChannel;
using scene::ImageType;
namespace word = grammar::word;

struct TypeRow {
  grammar::Symbol word;
  ImageType type;
};

constexpr TypeRow kTypes[] = {
    {word::kw_exr, ImageType::exr}, {word::kw_gif, ImageType::gif},   {word::kw_hdr, ImageType::hdr},
    {word::kw_iff, ImageType::iff}, {word::kw_jpeg, ImageType::jpeg}, {word::kw_pgm, ImageType::pgm},
    {word::kw_png, ImageType::png}, {word::kw_pot, ImageType::pot},   {word::kw_ppm, ImageType::ppm},
    {word::kw_sys, ImageType::sys}, {word::kw_tga, ImageType::tga},   {word::kw_tiff, ImageType::tiff},
};

/// Larger than any picture.
constexpr double kMaxSide = 1 << 16;

Image read_function_image(ElementStream& stream) {
  Context& context = stream.context();
  const auto& node = grammar::as<grammar::Function>(*stream.peek().node);
  Image image;
  image.type = ImageType::function;
  if (node.size.size() != 2) context.fail(node.span, "`function` as a picture needs its width and height");
  int* const sides[] = {&image.width, &image.height};
  for (std::size_t i = 0; i < 2; ++i) {
    const double side = evaluate_number(context, *node.size[i]);
    if (!(side >= 1 && side <= kMaxSide)) {
      context.fail(node.size[i]->span,
                   fmt::format("a picture's width and height must be from 1 to {:g}, found {:g}", kMaxSide, side));
    }
    *sides[i] = static_cast<int>(side);
  }
  image.function = read_function_operand(stream);
  return image;
}

void read_gamma(ElementStream& stream, Image& image) {
  image.gamma_srgb = stream.peek().is_word(word::kw_srgb);
  image.gamma.reset();
  if (image.gamma_srgb) {
    stream.drop();
  } else {
    image.gamma = read_positive(stream, "`gamma`");
  }
}

/// `filter all 0.5` or `filter 3, 0.5`.
void read_transparency(ElementStream& stream, std::optional<double>& all,
                       std::vector<scene::PaletteTransparency>& entries) {
  if (stream.peek().is_word(word::kw_all)) {
    stream.drop();
    all = read_number(stream, "an amount");
    return;
  }
  scene::PaletteTransparency entry;
  entry.index = static_cast<int>(read_number_in(stream, "the number of a colour of the palette", 0, 255));
  stream.accept_comma();
  entry.amount = read_number(stream, "an amount");
  entries.push_back(entry);
}

}  // namespace

std::string read_file_name(ElementStream& stream, std::string_view what) {
  Context& context = stream.context();
  const SourceSpan where = stream.peek().span;
  std::string name = read_name_of_file(stream, what);
  grammar::AccessProblem problem;
  if (!context.loader.use_file(name, context.current_unit(), problem)) {
    context.error(where, problem.message, problem.hint);
  }
  return name;
}

Image read_image_source(ElementStream& stream) {
  const Element next = stream.peek();
  if (next.is(ElementKind::value) && next.node->kind == grammar::NodeKind::function) return read_function_image(stream);
  Image image;
  if (next.is(ElementKind::word)) {
    const auto* const row = std::ranges::find(kTypes, next.word, &TypeRow::word);
    if (row == std::end(kTypes)) fail_expected(stream, "a type of picture or the name of a file");
    stream.drop();
    image.type = row->type;
  }
  image.file = read_file_name(stream, "the name of a picture's file");
  return image;
}

bool read_image_item(ElementStream& stream, Image& image) {
  const Element next = stream.peek();
  if (next.is(ElementKind::comma)) {
    stream.drop();
    return true;
  }
  if (!next.is(ElementKind::word)) return false;
  switch (static_cast<word::Index>(next.word)) {
    case word::kIndex_gamma:
      stream.drop();
      read_gamma(stream, image);
      return true;
    case word::kIndex_premultiplied:
      stream.drop();
      image.premultiplied = read_optional_truth(stream);
      return true;
    case word::kIndex_map_type:
      stream.drop();
      image.map_type = static_cast<int>(read_number_in(stream, "`map_type`", 0, 7));
      return true;
    case word::kIndex_interpolate:
      stream.drop();
      image.interpolate = static_cast<int>(read_number_in(stream, "`interpolate`", 0, 4));
      return true;
    case word::kIndex_once:
      stream.drop();
      image.once = true;
      return true;
    case word::kIndex_use_index:
      stream.drop();
      image.channel = ImageChannel::index;
      return true;
    case word::kIndex_use_color:
    case word::kIndex_use_colour:
      stream.drop();
      image.channel = ImageChannel::colour;
      return true;
    case word::kIndex_use_alpha:
      stream.drop();
      image.channel = ImageChannel::alpha;
      return true;
    case word::kIndex_filter:
      stream.drop();
      read_transparency(stream, image.filter_all, image.filters);
      return true;
    case word::kIndex_transmit:
      stream.drop();
      read_transparency(stream, image.transmit_all, image.transmits);
      return true;
    default: return false;
  }
}

scene::ImageId add_image(Context& context, Image&& image) {
  return add_record<scene::ImageId>(context, context.database.images, std::move(image));
}

}  // namespace isl::interpreter
