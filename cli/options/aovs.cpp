#include "cli/options/aovs.h"

#include "renderer/accuracy/measured_aovs.h"
#include "renderer/film/surface_aovs.h"

namespace isl::cli {

const render::Aovs& all_aovs() {
  static const render::Aovs kAll = [] {
    render::Aovs all;
    for (const render::SurfaceAov& row : render::surface_aovs()) all.push_back(&row.aov);
    all.push_back(&render::samples_aov());
    all.push_back(&render::noise_aov());
    all.push_back(&render::uncertified_aov());
    for (const render::MeasuredAov& row : render::measured_aovs()) all.push_back(&row.aov);
    return all;
  }();
  return kAll;
}

}  // namespace isl::cli
