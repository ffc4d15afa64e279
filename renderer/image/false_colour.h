// Numbers → colours, for pictures of what cannot be seen: costs and errors.
//
// The map is a polyline in OKLab (B. Ottosson, "A perceptual color space for image processing", 2020), walked at
// constant speed: equal steps of the value are equal distances in a space made so that these look equal. It rises in
// lightness throughout, dark blue, blue, teal, green, yellow, so that a grey print and every kind of eye still read it.
#pragma once

#include "renderer/shading/material.h"

namespace isl::render {

/// Linear light of the map at a share from 0 to 1; beyond it the colour of the nearer end. NaN is that of 0.
[[nodiscard]] Rgb false_colour(double share);

/// Colours that the map does not have, for what is no number.
inline const Rgb kBackgroundColour{0.012, 0.012, 0.012};  ///< nothing is there
inline const Rgb kMissedColour{0.9, 0.03, 0.03};          ///< a surface is there and was not found
inline const Rgb kFalseColour{0.85, 0.05, 0.75};          ///< a surface was found where nothing is

/// Which values the two ends of the map stand for.
struct ColourScale {
  double low = 0, high = 1;     ///< low < high; of a logarithmic scale 0 < low
  bool is_logarithmic = false;  ///< equal ratios, not differences, are equal steps

  [[nodiscard]] double share_of(double value) const;
};

}  // namespace isl::render
