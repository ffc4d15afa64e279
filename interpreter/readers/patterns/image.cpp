#include "interpreter/readers/patterns/image.h"

#include "interpreter/expressions.h"
#include "interpreter/readers/patterns/pattern_operands.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/records.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>

namespace isl::interpreter {
namespace {

using scene::Image;
using scene::ImageChannel;
using scene::ImageType;
namespace word = grammar::word;

struct TypeRow {
  grammar::Symbol word;
  ImageType type;
  std::array<std::string_view, 4> extensions;  ///< that a name without one gets, in POV-Ray's order
};

constexpr TypeRow kTypes[] = {
    {word::kw_bmp, ImageType::bmp, {".bmp", ".BMP"}},
    {word::kw_exr, ImageType::exr, {".exr", ".EXR"}},
    {word::kw_gif, ImageType::gif, {".gif", ".GIF"}},
    {word::kw_hdr, ImageType::hdr, {".hdr", ".HDR"}},
    {word::kw_iff, ImageType::iff, {".iff", ".IFF"}},
    {word::kw_jpeg, ImageType::jpeg, {".jpg", ".JPG", ".jpeg", ".JPEG"}},
    {word::kw_pgm, ImageType::pgm, {".pgm", ".PGM"}},
    {word::kw_png, ImageType::png, {".png", ".PNG"}},
    {word::kw_pot, ImageType::pot, {".pot", ".POT"}},
    {word::kw_ppm, ImageType::ppm, {".ppm", ".PPM"}},
    {word::kw_sys, ImageType::sys, {}},
    {word::kw_tga, ImageType::tga, {".tga", ".TGA"}},
    {word::kw_tiff, ImageType::tiff, {".tif", ".TIF", ".tiff", ".TIFF"}},
};

/// Those that a name without a type gets.
constexpr std::array<std::string_view, 2> kUntypedExtensions{".png", ".PNG"};

/// Larger than any picture.
constexpr double kMaxSide = 1 << 16;

Image read_function_image(ElementStream& stream) {
  Context& context = stream.context();
  const auto& node = grammar::as<grammar::Function>(*stream.peek().node);
  Image image;
  image.type = ImageType::function;
  image.said_at = context.origin(node.span);
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
/// True if it is the first.
bool read_transparency(ElementStream& stream, std::optional<double>& all,
                       std::vector<scene::PaletteTransparency>& entries) {
  if (stream.peek().is_word(word::kw_all)) {
    stream.drop();
    all = read_number(stream, "an amount");
    return true;
  }
  scene::PaletteTransparency entry;
  entry.index = static_cast<int>(read_number_in(stream, "the number of a colour of the palette", 0, 255));
  stream.accept_comma();
  entry.amount = read_number(stream, "an amount");
  entries.push_back(entry);
  return false;
}

/// True if the version in force scales the opacity that a file has itself by `all`, rather than adding to it.
bool scales_opacity(const ElementStream& stream) {
  return stream.context().version.number() >= LanguageVersion::kWithNewerWords;
}

/// A whole number, of which fractions are cut off, among those that are allowed. Any other number is an error, or, with
/// a warning, is taken as `otherwise`.
int read_one_of(ElementStream& stream, std::string_view what, std::initializer_list<int> allowed,
                std::optional<int> otherwise = std::nullopt) {
  const SourceSpan span = stream.peek().span;
  const double number = read_number(stream, what);
  const auto* const found = std::ranges::find(allowed, std::trunc(number));
  if (found != allowed.end()) return *found;
  std::string message = fmt::format("{} must be one of {}, found {:g}", what, fmt::join(allowed, ", "), number);
  if (!otherwise) stream.context().fail(span, std::move(message));
  stream.context().warn(span, std::move(message), fmt::format("it is taken as {}", *otherwise));
  return *otherwise;
}

void read_repeat(ElementStream& stream, Image& image) {
  const SourceSpan span = stream.peek().span;
  const scene::Vec3 repeat = read_vector(stream, "a vector after `repeat`");
  if (!(repeat.x > 0 && repeat.y > 0)) {
    stream.context().fail(span,
                          fmt::format("`repeat` must have terms above 0, found <{:g}, {:g}>", repeat.x, repeat.y));
  }
  image.repeat_x = repeat.x;
  image.repeat_y = repeat.y;
}

void read_offset(ElementStream& stream, Image& image) {
  const scene::Vec3 offset = read_vector(stream, "a vector after `offset`");
  image.offset_x = offset.x;
  image.offset_y = offset.y;
}

}  // namespace

NamedFile read_file(ElementStream& stream, std::string_view what, std::span<const std::string_view> extensions) {
  Context& context = stream.context();
  const SourceSpan span = stream.peek().span;
  NamedFile file;
  std::string& name = file.name;
  name = read_name_of_file(stream, what);
  file.said_at = context.origin(span);
  if (!std::filesystem::path(name).has_extension() && !context.loader.exists(name, context.current_unit())) {
    const auto exists = [&](std::string_view extension) {
      return !extension.empty() && context.loader.exists(fmt::format("{}{}", name, extension), context.current_unit());
    };
    if (const auto extension = std::ranges::find_if(extensions, exists); extension != extensions.end())
      name += *extension;
  }
  grammar::AccessProblem problem;
  file.bytes = context.loader.use_file(name, context.current_unit(), problem);
  if (!file.bytes) context.error(span, problem.message, problem.hint);
  return file;
}

Image read_image_source(ElementStream& stream) {
  const Element next = stream.peek();
  if (next.is(ElementKind::value) && next.node->kind == grammar::NodeKind::function) return read_function_image(stream);
  Image image;
  std::span<const std::string_view> extensions = kUntypedExtensions;
  if (next.is(ElementKind::word)) {
    const auto* const row = std::ranges::find(kTypes, next.word, &TypeRow::word);
    if (row == std::end(kTypes)) fail_expected(stream, "a type of picture or the name of a file");
    stream.drop();
    image.type = row->type;
    extensions = row->extensions;
  }
  NamedFile file = read_file(stream, "the name of a picture's file", extensions);
  image.file = std::move(file.name);
  image.bytes = std::move(file.bytes);
  image.said_at = file.said_at;
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
      // As in POV-Ray, a picture that is not an `image_map` lies flat if its type is unknown.
      image.map_type = read_one_of(stream, "`map_type`", {0, 1, 2, 5, 7},
                                   stream.word() == word::kw_image_map ? std::nullopt : std::optional(0));
      return true;
    case word::kIndex_interpolate:
      stream.drop();
      image.interpolate = read_one_of(stream, "`interpolate`", {0, 2, 3, 4});
      return true;
    case word::kIndex_repeat:
      stream.drop();
      read_repeat(stream, image);
      return true;
    case word::kIndex_offset:
      stream.drop();
      read_offset(stream, image);
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
      if (read_transparency(stream, image.filter_all, image.filters)) image.scales_opacity = scales_opacity(stream);
      return true;
    case word::kIndex_transmit:
      stream.drop();
      if (read_transparency(stream, image.transmit_all, image.transmits)) image.scales_opacity = scales_opacity(stream);
      return true;
    default: return false;
  }
}

scene::ImageId add_image(Context& context, Image&& image) {
  return add_record<scene::ImageId>(context, context.database.images, std::move(image));
}

}  // namespace isl::interpreter
