// The pictures of a report: the scene itself, and for each setting a map of its errors and one of its cost.
#pragma once

#include "cli/accuracy/report.h"
#include "renderer/image/false_colour.h"
#include "renderer/image/image.h"

#include <string>
#include <vector>

namespace isl::cli {

/// One scale for all settings, so that their pictures are comparable.
struct AccuracyScales {
  render::ColourScale error;  ///< pixels
  render::ColourScale cost;   ///< field evaluations of a ray
};

/// Pictures as `data:` addresses.
struct AccuracyPictures {
  AccuracyScales scales;
  std::string scene;
  std::vector<std::string> errors, costs;  ///< one for each rung
  std::string problem;                     ///< the error (lower case, no full stop), or ""
};

/// `scene` is the rendered picture.
[[nodiscard]] AccuracyPictures accuracy_pictures(const AccuracyReport& report, const render::Image& scene);

}  // namespace isl::cli
