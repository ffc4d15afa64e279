#include "renderer/film/surface_aovs.h"

#include <limits>

namespace isl::render {
namespace {

void set_triple(double* values, const Vec3& triple) {
  for (int i = 0; i < 3; ++i) values[i] = triple[i];
}

}  // namespace

std::span<const SurfaceAov> surface_aovs() {
  static const std::vector<SurfaceAov> kAovs{
      // From the eye along the ray, in scene units.
      {{.name = "depth", .channels = {"Z"}, .for_miss = std::numeric_limits<double>::infinity()},
       [](const SeenSurface& seen, double* values) { *values = seen.hit->t; }},
      // In world space.
      {{.name = "position", .channels = {"X", "Y", "Z"}},
       [](const SeenSurface& seen, double* values) { set_triple(values, seen.point->position); }},
      // In world space, outward, of unit length.
      {{.name = "normal", .channels = {"X", "Y", "Z"}},
       [](const SeenSurface& seen, double* values) { set_triple(values, seen.point->normal); }},
      // The pigment, linear.
      {{.name = "albedo", .channels = {"R", "G", "B"}},
       [](const SeenSurface& seen, double* values) {
         for (int i = 0; i < 3; ++i) values[i] = seen.albedo[i];
       }},
      // The tracer's instance.
      {{.name = "primitive", .channels = {"id"}, .value = AovValue::whole, .for_miss = scene::kNone},
       [](const SeenSurface& seen, double* values) { *values = seen.hit->instance; }},
  };
  return kAovs;
}

const Aov& samples_aov() {
  static const Aov kAov{.name = "samples",
                        .channels = {"count"},
                        .value = AovValue::whole,
                        .picture = {AovPicture::Kind::counts, "samples"}};
  return kAov;
}

const Aov& noise_aov() {
  static const Aov kAov{.name = "noise",
                        .channels = {"rms"},
                        .picture = {AovPicture::Kind::errors, "noise", {{"no estimate", kMissedColour}}}};
  return kAov;
}

const Aov& uncertified_aov() {
  static const Aov kAov{
      .name = "uncertified",
      .channels = {"kind"},
      .value = AovValue::whole,
      .picture = {AovPicture::Kind::kinds, "certainty", {{"undecided", kMissedColour}, {"refuted", kFalseColour}}}};
  return kAov;
}

}  // namespace isl::render
