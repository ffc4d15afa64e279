// Arbitrary output variables (AOVs): the values of a pixel besides its colour, each described by one record.
// renderer/film/surface_aovs.cpp fills those of the surfaces seen, renderer/accuracy/measured_aovs.cpp those of costs
// and errors. Files, false colours and the command line follow from the records.
#pragma once

#include "renderer/image/false_colour.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace isl::render {

enum class AovValue : std::uint8_t {
  real,   ///< kept and written as a 32-bit float
  whole,  ///< written as a 32-bit unsigned integer
};

/// How a layer is shown beside formats that hold no layers: in false colours with a legend (image/layer_picture.h).
struct AovPicture {
  enum class Kind : std::uint8_t {
    none,
    counts,  ///< of the first channel; 0 is the background
    errors,  ///< the first channel, over decades; infinite where a surface was missed or false, or noise is unknown
    kinds,   ///< the first channel is 0 for nothing to tell, else the number of a word, from 1
  };
  struct Word {
    std::string_view text;
    Rgb colour;
  };

  Kind kind = Kind::none;
  std::string_view title = {};
  std::vector<Word> words = {};
};

struct Aov {
  std::string_view name;  ///< in `--aov`, and before the dot in names of channels
  std::vector<std::string_view> channels;
  AovValue value = AovValue::real;
  double for_miss = 0;  ///< every channel of a pixel whose ray meets nothing
  AovPicture picture = {};
};

/// The values of an output variable over a picture's window, row by row.
struct Layer {
  const Aov* aov = nullptr;
  std::vector<double> values;  ///< aov->channels.size() a pixel; of real ones those that a float can hold

  /// As its pixels are before anything is known of them.
  Layer(const Aov& of, std::size_t pixels) : aov(&of), values(of.channels.size() * pixels, of.for_miss) {}

  [[nodiscard]] double* at(std::size_t pixel) { return &values[aov->channels.size() * pixel]; }
  [[nodiscard]] double at(std::size_t pixel, std::size_t channel) const {
    return values[aov->channels.size() * pixel + channel];
  }
  /// To be called once the values of a pixel are set.
  void round(std::size_t pixel) {
    if (aov->value == AovValue::whole) return;
    for (std::size_t i = 0; i < aov->channels.size(); ++i)
      at(pixel)[i] = static_cast<double>(static_cast<float>(at(pixel)[i]));
  }
};

/// Variables in the order in which they are listed and written.
using Aovs = std::vector<const Aov*>;

}  // namespace isl::render
