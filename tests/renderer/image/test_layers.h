// Output variables made up for tests of pictures and files: they need no film and no measuring.
#pragma once

#include "renderer/image/image.h"

#include <initializer_list>

namespace isl::render::test {

inline const Aov kDepth{.name = "depth", .channels = {"Z"}};
inline const Aov kNormal{.name = "normal", .channels = {"X", "Y", "Z"}};
inline const Aov kPrimitive{.name = "primitive", .channels = {"id"}, .value = AovValue::whole};
inline const Aov kSamples{.name = "samples", .channels = {"count"}, .value = AovValue::whole};
inline const Aov kCost{
    .name = "cost", .channels = {"evaluations", "seconds"}, .picture = {AovPicture::Kind::counts, "evaluations"}};
inline const Aov kError{.name = "error",
                        .channels = {"pixels", "units"},
                        .picture = {AovPicture::Kind::errors, "error", {{"missed or false", kMissedColour}}}};
inline const Aov kMissed{
    .name = "missed",
    .channels = {"kind"},
    .value = AovValue::whole,
    .picture = {AovPicture::Kind::kinds, "surfaces", {{"missed", kMissedColour}, {"false", kFalseColour}}}};

/// Adds an empty layer to the image, whose window is set.
inline Layer& add_layer(Image& image, const Aov& aov) { return image.layers.emplace_back(aov, image.window.area()); }

inline Layer& add_layer(Image& image, const Aov& aov, std::initializer_list<double> values) {
  Layer& layer = add_layer(image, aov);
  layer.values = values;
  return layer;
}

}  // namespace isl::render::test
