#include "renderer/patterns/kinds/sampled_image.h"

#include "renderer/patterns/kinds/pigment_colour.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace isl::render {
namespace {

using scene::Colour;

double gray_of(double red, double green, double blue) { return 0.297 * red + 0.589 * green + 0.114 * blue; }

}  // namespace

SampledImage::SampledImage(const scene::Image& image, std::shared_ptr<const Texels> texels, const WorkingGamma& working)
    : texels_(std::move(texels)),
      placing_(image, texels_->width, texels_->height),
      image_(image),
      meaning_of_(image, *texels_, working),
      is_premultiplied_(texels_->has_alpha() && image.premultiplied.value_or(texels_->is_premultiplied)) {
  const auto is_palette = texels_->sample == Texels::Sample::index;
  if (texels_->sample != Texels::Sample::real) {
    const std::size_t most = texels_->sample == Texels::Sample::bits16 ? 65535 : 255;
    meaning_.resize(most + 1);
    for (std::size_t code = 0; code <= most; ++code)
      meaning_[code] = static_cast<float>(meaning_of_(static_cast<double>(code) / static_cast<double>(most)));
  }
  if (!is_palette) {
    added_filter_ = static_cast<float>(image.filter_all.value_or(0));
    added_transmit_ = static_cast<float>(image.transmit_all.value_or(0));
    return;
  }
  for (const Texels::PaletteColour& colour : texels_->palette) {
    palette_.push_back({meaning_[colour[0]], meaning_[colour[1]], meaning_[colour[2]],
                        static_cast<float>(image.filter_all.value_or(0)),
                        static_cast<float>(image.transmit_all.value_or(1 - colour[3] / 255.0))});
  }
  palette_.resize(256, palette_.empty() ? Texel{} : palette_.back());
  for (const auto& [number, amount] : image.filters)
    palette_[static_cast<std::size_t>(number)].filter = static_cast<float>(amount);
  for (const auto& [number, amount] : image.transmits)
    palette_[static_cast<std::size_t>(number)].transmit = static_cast<float>(amount);
}

// ---- From texels to values ------------------------------------------------------------------------------------------

float SampledImage::decoded(std::size_t value) const noexcept {
  switch (texels_->sample) {
    case Texels::Sample::index:
    case Texels::Sample::bits8: return meaning_[std::to_integer<std::size_t>(texels_->values[value])];
    case Texels::Sample::bits16: {
      std::uint16_t code;
      std::memcpy(&code, &texels_->values[value * sizeof code], sizeof code);
      return meaning_[code];
    }
    case Texels::Sample::real: break;
  }
  return static_cast<float>(meaning_of_(real_at(value)));
}

float SampledImage::real_at(std::size_t value) const noexcept {
  float real;
  std::memcpy(&real, &texels_->values[value * sizeof real], sizeof real);
  return real;
}

float SampledImage::alpha(std::size_t number) const noexcept {
  const auto channels = static_cast<std::size_t>(texels_->channels);
  const std::size_t value = number * channels + channels - 1;
  switch (texels_->sample) {
    case Texels::Sample::index: return 1;
    case Texels::Sample::bits8: return static_cast<float>(std::to_integer<int>(texels_->values[value])) / 255;
    case Texels::Sample::bits16: {
      std::uint16_t code;
      std::memcpy(&code, &texels_->values[value * sizeof code], sizeof code);
      return static_cast<float>(code) / 65535;
    }
    case Texels::Sample::real: break;
  }
  return real_at(value);
}

int SampledImage::index(std::size_t number) const noexcept { return std::to_integer<int>(texels_->values[number]); }

SampledImage::Texel SampledImage::texel(std::size_t number) const noexcept {
  if (texels_->sample == Texels::Sample::index) return palette_[std::to_integer<std::size_t>(texels_->values[number])];
  const auto channels = static_cast<std::size_t>(texels_->channels);
  const std::size_t first = number * channels;
  Texel texel{decoded(first), 0, 0, added_filter_, added_transmit_};
  texel.green = channels < 3 ? texel.red : decoded(first + 1);
  texel.blue = channels < 3 ? texel.red : decoded(first + 2);
  if (texels_->has_alpha()) {
    const float opaque = alpha(number);
    if (image_.scales_opacity) {
      texel.filter *= opaque;
      texel.transmit = 1 - opaque * (1 - added_transmit_);
    } else {
      texel.transmit += 1 - opaque;
    }
    if (is_premultiplied_ && opaque > 0) {
      texel.red /= opaque;
      texel.green /= opaque;
      texel.blue /= opaque;
    }
  }
  return texel;
}

template <class ValueOf>
double SampledImage::mean(const TexelPlace& place, const ValueOf& value_of) const noexcept {
  if (!placing_.mixes_texels()) return value_of(placing_.texel_at(place));
  const TexelTaps taps = placing_.taps_of(place);
  double sum = 0;
  for (int i = 0; i < taps.count; ++i) {
    const TexelTap& tap = taps.taps[static_cast<std::size_t>(i)];
    sum += tap.weight * value_of(tap.texel);
  }
  return sum;
}

Colour SampledImage::colour_at(const TexelPlace& place) const noexcept {
  if (!placing_.mixes_texels()) {
    const Texel colour = texel(placing_.texel_at(place));
    return {colour.red, colour.green, colour.blue, colour.filter, colour.transmit};
  }
  const TexelTaps taps = placing_.taps_of(place);
  Colour sum;
  for (int i = 0; i < taps.count; ++i) {
    const TexelTap& tap = taps.taps[static_cast<std::size_t>(i)];
    const Texel colour = texel(tap.texel);
    sum.red += tap.weight * colour.red;
    sum.green += tap.weight * colour.green;
    sum.blue += tap.weight * colour.blue;
    sum.filter += tap.weight * colour.filter;
    sum.transmit += tap.weight * colour.transmit;
  }
  return in_single(sum);
}

bool SampledImage::uses_index() const noexcept {
  const bool is_material = image_.choices > 0;
  return texels_->sample == Texels::Sample::index &&
         (image_.channel == scene::ImageChannel::index ||
          (image_.channel == scene::ImageChannel::automatic && is_material));
}

double SampledImage::value_at(const TexelPlace& place) const noexcept {
  const auto value = [this](std::size_t number) -> double {
    const Texel colour = texel(number);
    if (image_.channel == scene::ImageChannel::alpha) return texels_->has_alpha() ? colour.transmit : colour.red;
    return brightness(colour);
  };
  return std::clamp(mean(place, value), 0.0, 1.0);
}

double SampledImage::height_at(const TexelPlace& place) const noexcept {
  return mean(place, [this](std::size_t number) { return uses_index() ? index(number) : brightness(texel(number)); });
}

double SampledImage::brightness(const Texel& texel) const noexcept {
  const bool is_grey_byte = texels_->sample == Texels::Sample::bits8 && texels_->channels < 3;
  if (is_grey_byte) return std::floor(red_code(texel)) / 255;
  return gray_of(texel.red, texel.green, texel.blue);
}

/// The red as a number from 0 to 255. Grey is added up from three shares in single precision, whose rounding the
/// fraction that is cut off shows: so does POV-Ray, and textures are chosen by these numbers.
double SampledImage::red_code(const Texel& texel) const noexcept {
  if (texels_->channels >= 3) return texel.red * 255.0;
  const float sum = 0.297F * texel.red + 0.589F * texel.red;
  return (sum + 0.114F * texel.red) * 255.0F;
}

int SampledImage::choice_at(const TexelPlace& place) const noexcept {
  const double number = mean(place, [this](std::size_t texel_at) -> double {
    return uses_index() ? index(texel_at) : red_code(texel(texel_at));
  });
  // Rounded to single precision, in which sums of whole numbers are whole.
  const auto single = static_cast<float>(number);
  const int whole = single > 0 ? static_cast<int>(std::min(single, 65535.0F)) : 0;
  return whole > image_.choices ? whole % image_.choices : whole;
}

}  // namespace isl::render
