// Maps numbers to colours, for pictures of invisible quantities: costs and errors.
//
// The map is a polyline in OKLab (B. Ottosson, "A perceptual color space for image processing", 2020), walked at
// constant speed: equal steps of the value are equal distances in a space in which these look equal. Lightness rises
// throughout, from dark blue over blue, teal and green to yellow, so that it can be read in a grey print and by every
// kind of eye.
#pragma once

#include "renderer/shading/material.h"

namespace isl::render {

/// Colour of the map, as linear light, at a share from 0 to 1; beyond it the colour of the nearer end. NaN gets that of
/// 0.
[[nodiscard]] Rgb false_colour(double share);

/// Colours that the map does not contain, for pixels without a number.
inline const Rgb kBackgroundColour{0.012, 0.012, 0.012};  ///< nothing is there
inline const Rgb kMissedColour{0.9, 0.03, 0.03};          ///< a surface is there and was not found
inline const Rgb kFalseColour{0.85, 0.05, 0.75};          ///< a surface was found where nothing is
inline const Rgb kUndecidedColour{0.5, 0.5, 0.5};         ///< the reference does not know whether a surface is there

/// The values that the two ends of the map stand for.
struct ColourScale {
  double low = 0, high = 1;     ///< low < high; 0 < low if the scale is logarithmic
  bool is_logarithmic = false;  ///< equal ratios, not differences, are equal steps

  [[nodiscard]] double share_of(double value) const;
};

}  // namespace isl::render
