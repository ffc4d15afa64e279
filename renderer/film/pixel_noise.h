// The noise of every pixel, as its samples tell (film/block_noise.h), and the choice of the pixels that get more.
//
// A few samples give only a rough estimate of their noise. A pixel that stopped by its own estimate alone would stop
// where its samples happen to be alike, and its error would be larger than what was asked for. Therefore the estimates
// of neighbouring pixels are averaged.
//
// A pixel whose few samples are all equal may have missed what others see, such as the light that comes through a gap.
// Its neighbours tell how much that can be.
#pragma once

#include "renderer/film/block_noise.h"
#include "renderer/film/film.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace isl::render {

/// Passes after which a picture is finished. Each looks at the neighbours of the pixels that the one before looked at,
/// so a pixel depends on others up to this distance.
inline constexpr int kMostNoisePasses = 16;

class PixelNoise {
 public:
  /// Memory that the noise of so many pixels takes.
  [[nodiscard]] static std::size_t bytes_for(std::size_t pixels) { return pixels * (sizeof(Pixel) + 2); }

  /// `film` gets the noise for its layer.
  explicit PixelNoise(Film& film);

  /// Chooses the pixels that have more noise than `most` and less than `most_samples`; all at first. Returns their
  /// number. Rows are worked on in parallel.
  std::uint64_t choose(double most, std::uint32_t most_samples);
  [[nodiscard]] bool is_chosen(std::size_t pixel) const { return chosen_[pixel] != 0; }
  /// The number of pixels with more noise than that, once nothing is to be chosen any more.
  [[nodiscard]] std::uint64_t count_above(const PixelRect& window, double noise) const;

  /// Takes the samples of a pass, which are in the film already: as many as the pixel had before, or all it has. Other
  /// threads may do so for other pixels meanwhile.
  void finish(std::size_t pixel, const BlockNoise& samples);

 private:
  struct Pixel {
    double deviation = std::numeric_limits<double>::infinity();  ///< of one sample, such that the pixel's samples
                                                                 ///< would have their noise if they were random
    double slope = 0;                                            ///< of a display's codes over the samples' brightness
    float noise = std::numeric_limits<float>::infinity();        ///< together with what may be missed
    float darkest = std::numeric_limits<float>::infinity(), brightest = -std::numeric_limits<float>::infinity();
  };

  struct Column;
  void set_columns(int y, std::vector<Column>& columns) const;

  /// The roots of the channels' shares in the mean square of a colour's three, and the whole of alpha's, as a display
  /// shows them.
  [[nodiscard]] BlockNoise::Value slopes(const BlockNoise::Value& mean) const;

  Film& film_;
  std::vector<double> slopes_;  ///< of a channel, for means from 0 to 1 at even distances
  std::vector<Pixel> pixels_;
  std::vector<std::uint8_t> chosen_, chosen_before_;  ///< bytes, so that threads can write to neighbours
};

}  // namespace isl::render
