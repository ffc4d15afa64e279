#include "renderer/image/image_file.h"

#include "base/check.h"
#include "base/parallel.h"
#include "renderer/image/display_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>

namespace isl::render {
namespace {

constexpr std::array<const char*, 4> kColourNames{"R", "G", "B", "A"};

/// The planes of a file, and the memory that they point into.
class PlaneSet {
 public:
  explicit PlaneSet(std::size_t pixels) : pixels_(pixels) {}

  /// Adds a plane with `value_of(pixel)` for every pixel, in the given type.
  template <class ValueOf>
  void add(std::string name, IslSampleType type, const ValueOf& value_of) {
    switch (type) {
      case ISL_UINT8: fill<std::uint8_t>(std::move(name), type, value_of); break;
      case ISL_UINT16: fill<std::uint16_t>(std::move(name), type, value_of); break;
      case ISL_UINT32: fill<std::uint32_t>(std::move(name), type, value_of); break;
      case ISL_HALF:
      case ISL_FLOAT: fill<float>(std::move(name), type, value_of); break;
    }
  }

  /// Adds red, green and blue in one pass over the picture. `values_of(pixel)` gives all three; it is called once for
  /// pixels in a row of which each is `like(pixel)` the one before, since much of a picture may be of one colour.
  template <class Value, class ValuesOf, class Like>
  void add_colours(IslSampleType type, const ValuesOf& values_of, const Like& like) {
    std::array<Value*, 3> planes;
    for (std::size_t channel = 0; channel < planes.size(); ++channel)
      planes[channel] = add_plane<Value>(kColourNames[channel], type);
    for_each_part([&](std::size_t begin, std::size_t end) {
      auto values = values_of(begin);
      for (std::size_t pixel = begin; pixel < end; ++pixel) {
        if (pixel > begin && !like(pixel)) values = values_of(pixel);
        for (std::size_t channel = 0; channel < planes.size(); ++channel)
          planes[channel][pixel] = static_cast<Value>(values[channel]);
      }
    });
  }

  [[nodiscard]] const std::vector<IslPlane>& planes() const { return planes_; }

 private:
  template <class Value, class ValueOf>
  void fill(std::string name, IslSampleType type, const ValueOf& value_of) {
    Value* values = add_plane<Value>(std::move(name), type);
    for_each_part([&](std::size_t begin, std::size_t end) {
      for (std::size_t pixel = begin; pixel < end; ++pixel) values[pixel] = static_cast<Value>(value_of(pixel));
    });
  }

  template <class Value>
  Value* add_plane(std::string name, IslSampleType type) {
    names_.push_back(std::move(name));
    std::vector<unsigned char>& memory = memory_.emplace_back(pixels_ * sizeof(Value));
    Value* values = reinterpret_cast<Value*>(memory.data());
    planes_.push_back({names_.back().c_str(), type, values});
    return values;
  }

  /// Calls `use(begin, end)` for parts of the pixels, on all threads.
  template <class Use>
  void for_each_part(const Use& use) const {
    parallel_for((pixels_ + kTogether - 1) / kTogether,
                 [&](std::size_t part) { use(part * kTogether, std::min((part + 1) * kTogether, pixels_)); });
  }

  /// Pixels that one task converts: enough that its start does not count.
  static constexpr std::size_t kTogether = std::size_t{1} << 16;

  std::size_t pixels_;
  std::deque<std::string> names_;  ///< deques, because the planes point at their elements
  std::deque<std::vector<unsigned char>> memory_;
  std::vector<IslPlane> planes_;
};

/// Adds code values of a display, with the colour divided by alpha if there is alpha.
void add_display_planes(PlaneSet& planes, const Image& image, IslSampleType type, bool with_alpha) {
  const int most = type == ISL_UINT8 ? 255 : 65535;
  const DisplayCodes codes(most);
  const auto codes_of = [&](std::size_t pixel) {
    const double* rgba = &image.rgba[4 * pixel];
    const auto code = [&](double value) { return codes(with_alpha && rgba[3] > 0 ? value / rgba[3] : value); };
    return std::array{code(rgba[0]), code(rgba[1]), code(rgba[2])};
  };
  const auto is_like_the_last = [&](std::size_t pixel) {
    const double* rgba = &image.rgba[4 * pixel];
    return std::equal(rgba, rgba + 4, rgba - 4);
  };
  if (type == ISL_UINT8) {
    planes.add_colours<std::uint8_t>(type, codes_of, is_like_the_last);
  } else {
    planes.add_colours<std::uint16_t>(type, codes_of, is_like_the_last);
  }
  if (!with_alpha) return;
  planes.add(kColourNames[3], type, [&](std::size_t pixel) {
    return std::floor(std::clamp(image.rgba[4 * pixel + 3], 0.0, 1.0) * most + 0.5);
  });
}

void add_linear_planes(PlaneSet& planes, const Image& image, IslSampleType type, bool with_alpha) {
  for (std::size_t channel = 0; channel < (with_alpha ? 4 : 3); ++channel) {
    // Halves end long before the floats that an image may hold.
    const double most = type == ISL_HALF ? 65504 : std::numeric_limits<float>::max();
    planes.add(kColourNames[channel], type,
               [&, most](std::size_t pixel) { return std::clamp(image.rgba[4 * pixel + channel], -most, most); });
  }
}

void add_layers(PlaneSet& planes, const std::vector<Layer>& layers) {
  for (const Layer& layer : layers) {
    const Aov& aov = *layer.aov;
    for (std::size_t channel = 0; channel < aov.channels.size(); ++channel) {
      planes.add(fmt::format("{}.{}", aov.name, aov.channels[channel]),
                 aov.value == AovValue::whole ? ISL_UINT32 : ISL_FLOAT,
                 [&](std::size_t pixel) { return layer.at(pixel, channel); });
    }
  }
}

bool has_alpha_channel(std::string_view format) { return format == "png" || format == "exr" || format == "tif"; }

void add_planes(PlaneSet& planes, const Image& image, std::string_view format, bool with_alpha,
                const ImageFileOptions& options) {
  if (format == "exr") {
    add_linear_planes(planes, image, options.exr_float ? ISL_FLOAT : ISL_HALF, with_alpha);
    add_layers(planes, image.layers);
  } else if (format == "hdr") {
    add_linear_planes(planes, image, ISL_FLOAT, false);
  } else {
    const bool is_wide = options.bits == 0 ? format_holds_bits(format, 16) : options.bits == 16;
    add_display_planes(planes, image, is_wide ? ISL_UINT16 : ISL_UINT8, with_alpha);
  }
}

}  // namespace

std::string image_format_of(std::string_view path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string_view::npos || path[dot] == '/') return "";
  std::string extension(path.substr(dot + 1));
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (extension == "tiff") extension = "tif";
  if (extension == "jpeg") extension = "jpg";
  for (const char* known : {"png", "exr", "tif", "jpg", "ppm", "hdr"}) {
    if (extension == known) return extension;
  }
  return "";
}

bool is_linear_format(std::string_view format) { return format == "exr" || format == "hdr"; }

bool format_holds_bits(std::string_view format, int bits) {
  if (is_linear_format(format)) return false;
  return bits == 8 || (bits == 16 && (format == "png" || format == "tif"));
}

EncodedFile encode_image(const Image& image, std::string_view format, const ImageFileOptions& options) {
  ISL_CHECK(image_format_of(fmt::format(".{}", format)) == format, "format {}", format);
  ISL_CHECK(options.bits == 0 || is_linear_format(format) || format_holds_bits(format, options.bits), "{} bits of {}",
            options.bits, format);
  if (image.window.empty()) return {{}, "the picture has no pixels: its window is empty"};
  const bool with_alpha = image.has_alpha && has_alpha_channel(format);
  PlaneSet planes(image.window.area());
  with_threads(std::max(options.threads, 1), [&] { add_planes(planes, image, format, with_alpha, options); });
  std::vector<IslText> texts;
  for (const auto& [name, value] : options.metadata) texts.push_back({name.c_str(), value.c_str()});
  const std::string format_name(format);
  IslImage description{};
  description.format = format_name.c_str();
  description.width = image.window.width();
  description.height = image.window.height();
  description.x = image.window.x0;
  description.y = image.window.y0;
  description.full_width = image.full_width;
  description.full_height = image.full_height;
  description.is_srgb = is_linear_format(format) ? 0 : 1;
  description.alpha_plane = with_alpha ? 3 : -1;
  description.plane_count = static_cast<int>(planes.planes().size());
  description.planes = planes.planes().data();
  description.threads = options.threads;
  description.text_count = static_cast<int>(texts.size());
  description.texts = texts.data();
  return encode_by_module(description);
}

}  // namespace isl::render
