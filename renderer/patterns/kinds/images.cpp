// Patterns of images: image_map, image_pattern, bump_map and material_map. The texels are found by SampledImage; images
// that no picture needs are not there, and give 0.
#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/patterns/kinds/sampled_image.h"

namespace isl::render {
namespace {

constexpr PatternHosts kPigments{.normal = false, .texture = false, .function = false};
/// Outside an image that is mapped once there is nothing to see, but the finish shows, as in POV-Ray.
constexpr scene::Colour kClear{1, 1, 1, 0, 1};

const SampledImage* image_of(const PatternPoint& at) noexcept {
  const auto* const id = std::get_if<scene::ImageId>(&at.pattern.operands);
  const ImageTable* const images = at.world.images;
  return id && images && index(*id) < images->size() ? (*images)[index(*id)].get() : nullptr;
}

scene::Colour colour_of_image(const PatternPoint& at) noexcept {
  const SampledImage* const image = image_of(at);
  const auto place = image ? image->placing().place_of(at.point) : std::nullopt;
  return place ? image->colour_at(*place) : kClear;
}

double value_of_image(const PatternPoint& at) noexcept {
  const SampledImage* const image = image_of(at);
  const auto place = image ? image->placing().place_of(at.point) : std::nullopt;
  return place ? image->value_at(*place) : 0;
}

/// Outside an image that is mapped once, the first texture is chosen.
double choice_of_image(const PatternPoint& at) noexcept {
  const SampledImage* const image = image_of(at);
  const auto place = image ? image->placing().place_of(at.point) : std::nullopt;
  return place ? image->choice_at(*place) : 0;
}

/// Bends the normal as the triangle of three texels slopes whose heights stand in the direction of the normal. Texels
/// are 1 apart, so that the size of the image in space does not matter.
Vec3 bent_by_image(const PatternPoint& at, const Vec3& normal, double size) noexcept {
  const SampledImage* const image = image_of(at);
  const auto place = image ? image->placing().place_of(at.point) : std::nullopt;
  if (!place) return normal;
  const double middle = size * image->height_at(*place);
  const double left = size * image->height_at(image->placing().neighbour(*place, -1, -1));
  const double right = size * image->height_at(image->placing().neighbour(*place, 1, -1));
  // (q3 − q2) × (q1 − q2) with q1 = (0, middle, 0), q2 = (−1, left, 1), q3 = (1, right, 1).
  const Vec3 slope = Vec3(2, right - left, 0).cross(Vec3(1, middle - left, -1));
  Vec3 across(-normal.z, 0, normal.x);  // normal × y
  const double length = across.length();
  across = length > 0 ? across * (1 / length) : Vec3(1, 0, 0);
  const Vec3 along = across.cross(normal).normalized();
  return across * slope.x + normal * slope.y - along * slope.z;
}

}  // namespace

constinit const PatternInfo pattern_kinds::bump_map{
    .block = PatternBlock::of_host, .hosts = kNormalsOnly, .choice = PatternChoice::own, .bend = bent_by_image};
constinit const PatternInfo pattern_kinds::image_map{.block = PatternBlock::image,
                                                     .hosts = kPigments,
                                                     .instead = "image_pattern",
                                                     .choice = PatternChoice::own,
                                                     .colour = colour_of_image};
constinit const PatternInfo pattern_kinds::image_pattern{.block = PatternBlock::image, .value = value_of_image};
/// A material_map replaces a texture and is read by the reader of textures.
constinit const PatternInfo pattern_kinds::material_map{.block = PatternBlock::of_host,
                                                        .hosts = {.pigment = false, .normal = false, .function = false},
                                                        .choice = PatternChoice::own,
                                                        .value = choice_of_image};

}  // namespace isl::render
