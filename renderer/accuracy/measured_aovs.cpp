#include "renderer/accuracy/measured_aovs.h"

#include <limits>

namespace isl::render {
namespace {

constexpr double kWrong = std::numeric_limits<double>::infinity();

}  // namespace

std::span<const MeasuredAov> measured_aovs() {
  static const std::vector<MeasuredAov> kAovs{
      // Seconds are those of one run: no two have the same.
      {.aov = {.name = "cost",
               .channels = {"evaluations", "seconds"},
               .picture = {AovPicture::Kind::counts, "field evaluations"}},
       .fill =
           [](const RayMeasure& found, const RayError& /*error*/, double* values) {
             values[0] = static_cast<double>(found.counters.field_evaluations);
             values[1] = found.seconds;
           }},
      // Along the ray, in pixels and in scene units; infinite where a surface was missed or false, 0 where the
      // reference
      // is undecided.
      {.aov = {.name = "error",
               .channels = {"pixels", "units"},
               .picture = {AovPicture::Kind::errors, "error px", {{"missed or false", kMissedColour}}}},
       .needs_reference = true,
       .fill =
           [](const RayMeasure& /*found*/, const RayError& error, double* values) {
             const bool is_wrong = error.outcome == RayOutcome::missed || error.outcome == RayOutcome::false_surface;
             values[0] = is_wrong ? kWrong : error.pixels;
             values[1] = is_wrong ? kWrong : error.units;
           }},
      // Cells of the grid whose fields were solved.
      {.aov = {.name = "solver_steps",
               .channels = {"count"},
               .value = AovValue::whole,
               .picture = {AovPicture::Kind::counts, "solver steps"}},
       .fill = [](const RayMeasure& found, const RayError& /*error*/,
                  double* values) { *values = static_cast<double>(found.counters.cells); }},
      // 1: a surface is there and none was found; 2: the other way round; 3: the reference does not know.
      {.aov = {.name = "missed",
               .channels = {"kind"},
               .value = AovValue::whole,
               .picture = {AovPicture::Kind::kinds,
                           "surfaces",
                           {{"missed", kMissedColour}, {"false", kFalseColour}, {"undecided", kUndecidedColour}}}},
       .needs_reference = true,
       .fill =
           [](const RayMeasure& /*found*/, const RayError& error, double* values) {
             *values = error.outcome == RayOutcome::missed          ? 1
                       : error.outcome == RayOutcome::false_surface ? 2
                       : error.outcome == RayOutcome::undecided     ? 3
                                                                    : 0;
           }},
  };
  return kAovs;
}

}  // namespace isl::render
