#include "renderer/image/image_library.h"

#include "renderer/image/texel_file.h"
#include "renderer/patterns/patterns.h"
#include "renderer/queries/insides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace isl::render {
namespace {

using scene::Database;
using scene::Refusal;

constexpr const char* kMoreMemory = "`--max-memory` raises the limit";

/// Names the item of the statement that needs a palette, if the file has none; "" if nothing is missing.
std::string lack_of_palette(const scene::Image& image, const Texels& texels) {
  const bool takes_numbers = image.channel == scene::ImageChannel::index ||
                             (image.choices > 0 && image.channel != scene::ImageChannel::colour);
  if (takes_numbers && texels.hides_palette) {
    return "the numbers of its colours cannot be read; `use_color` takes the colours, and a PNG or GIF file has "
           "numbers";
  }
  if (image.filters.empty() && image.transmits.empty()) return "";
  const char* const word = image.filters.empty() ? "transmit" : "filter";
  if (texels.sample != Texels::Sample::index)
    return fmt::format("`{}` of a number needs an image with a palette, and this one has none that can be read", word);
  const int size = static_cast<int>(texels.palette.size());
  for (const auto& entries : {image.filters, image.transmits}) {
    for (const scene::PaletteTransparency& entry : entries) {
      if (entry.index >= size) {
        return fmt::format("`{}` of colour {}, and the palette of this image ends at {}",
                           &entries == &image.filters ? "filter" : "transmit", entry.index, size - 1);
      }
    }
  }
  return "";
}

/// The 16 bits that POV-Ray keeps of a function's value: its whole number of 65535ths, in single precision, which wraps
/// around outside of the range from 0 to 1.
std::uint16_t code_of(double value) {
  constexpr float kMost = 65535, kCodes = 65536;
  const float rest = std::fmod(std::trunc(static_cast<float>(value) * kMost), kCodes);  // NaN for infinities
  if (rest < 0) return static_cast<std::uint16_t>(rest + kCodes);
  return rest > 0 ? static_cast<std::uint16_t>(rest) : 0;
}

}  // namespace

WorkingGamma working_gamma(const scene::Settings& settings) {
  WorkingGamma working;
  if (settings.language_version < 3.7) {
    working.converts = settings.assumed_gamma || settings.assumed_gamma_srgb ? WorkingGamma::Converts::stating
                                                                             : WorkingGamma::Converts::named;
  }
  if (settings.assumed_gamma_srgb) {
    working.kind = WorkingGamma::Kind::srgb;
  } else if (settings.assumed_gamma && *settings.assumed_gamma != 1) {
    working.kind = WorkingGamma::Kind::power;
    working.gamma = *settings.assumed_gamma;
  }
  return working;
}

std::optional<Refusal> ImageLibrary::prepare(const Database& database, const std::vector<bool>& is_needed,
                                             ImageTable& table) {
  table.resize(database.images.size());
  // Images of functions may look at the others.
  for (const bool is_function : {false, true}) {
    for (std::size_t i = 0; i < table.size(); ++i) {
      const scene::Image& image = database.images[i];
      if (table[i] || !is_needed[i] || (image.type == scene::ImageType::function) != is_function) continue;
      if (auto refusal = prepare(database, image, table, i)) return refusal;
    }
  }
  return std::nullopt;
}

std::optional<Refusal> ImageLibrary::prepare(const Database& database, const scene::Image& image, ImageTable& table,
                                             std::size_t number) {
  std::shared_ptr<const Texels> texels;
  if (image.type == scene::ImageType::function) {
    std::string problem;
    texels = sample(database, image, table, problem);
    if (!texels) return Refusal{problem, kMoreMemory, image.said_at};
  } else {
    // A file that could not be read was reported with the scene.
    if (!image.bytes) return std::nullopt;
    std::shared_ptr<const Texels>& known = decoded_[{image.bytes, image.type}];
    if (!known) {
      DecodedTexels decoded = decode_texels(*image.bytes, image.file, image.type, run_);
      if (!decoded.texels) {
        return Refusal{fmt::format("the image `{}`: {}", image.file, decoded.problem),
                       decoded.is_too_large ? kMoreMemory : "", image.said_at};
      }
      known = std::move(decoded.texels);
    }
    texels = known;
  }
  if (std::string lack = lack_of_palette(image, *texels); !lack.empty())
    return Refusal{fmt::format("the image `{}`: {}", image.file, lack), "", image.said_at};
  table[number] = std::make_unique<const SampledImage>(image, std::move(texels), working_gamma(database.settings));
  return std::nullopt;
}

std::shared_ptr<const Texels> ImageLibrary::sample(const Database& database, const scene::Image& image,
                                                   const ImageTable& table, std::string& problem) {
  auto texels = std::make_shared<Texels>();
  texels->width = image.width;
  texels->height = image.height;
  texels->channels = 1;
  texels->sample = Texels::Sample::bits16;
  texels->transfer = Transfer::working;
  texels->charge = Charge(run_.budget);
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  if (!texels->charge.grow(width * height * sizeof(std::uint16_t))) {
    problem = fmt::format("the {}x{} pixels of the function take more memory than the limit leaves", width, height);
    return nullptr;
  }
  texels->values.resize(width * height * sizeof(std::uint16_t));
  const Insides insides(database, run_);
  const Patterns patterns(database, &insides, database.settings.number_of_waves, &table);
  const scene::Function& function = *database.functions[index(image.function)];
  // POV-Ray spans the function's square from the first pixel to the last one.
  const double right = std::max(image.width - 1, 1), low = std::max(image.height - 1, 1);
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      const double arguments[] = {static_cast<double>(column) / right, static_cast<double>(row) / low, 0};
      values::Environment environment(values::noise_generator_of(database.settings.noise_generator), run_, &patterns);
      const double value =
          values::evaluate(function, std::span(arguments).first(function.parameter_count), environment)[0];
      if (environment.is_spent()) {
        problem = "a pixel of the function takes more steps than the run allows";
        return nullptr;
      }
      const std::uint16_t code = code_of(value);
      std::memcpy(&texels->values[(row * width + column) * sizeof code], &code, sizeof code);
    }
  }
  return texels;
}

}  // namespace isl::render
