#include "cli/output/closing_line.h"

#include "cli/output/printable_text.h"

#include <fmt/format.h>

namespace isl::cli {

std::string closing_line(const std::vector<std::string>& names, const render::Image& image, double seconds) {
  const int width = image.window.width(), height = image.window.height();
  std::string size = fmt::format("{}x{}", width, height);
  if (width != image.full_width || height != image.full_height) {
    size += fmt::format(" of {}x{}", image.full_width, image.full_height);
  }
  // Hundredths of a second distinguish short runs and mean nothing for long ones.
  const int digits = seconds < 100 ? 2 : 0;
  return fmt::format("isl: {}, {}, {:.{}f} s", visible_name(fmt::format("{}", fmt::join(names, ", "))), size, seconds,
                     digits);
}

std::string uncertain_line(const render::RenderStatistics& statistics) {
  const std::uint64_t undecided = statistics.undecided_pixels, refuted = statistics.refuted_pixels;
  const std::uint64_t all = undecided + refuted;
  if (all == 0) return {};
  return fmt::format(
      "{} {} could be off by more than the tolerance ({} undecided, {} refuted); `--aov uncertified` shows "
      "which{}",
      all, all == 1 ? "pixel" : "pixels", undecided, refuted,
      statistics.counters.spent_rays > 0 ? ", and a greater `--max-ray-steps` may decide them" : "");
}

std::string lost_line(const render::LostSamples& lost) {
  if (lost.samples == 0) return {};
  return fmt::format(
      "{} {} of {} {} {} left out, because the colour is not a finite number; the first is at pixel {},{}{}",
      lost.samples, lost.samples == 1 ? "sample" : "samples", lost.pixels, lost.pixels == 1 ? "pixel" : "pixels",
      lost.samples == 1 ? "is" : "are", lost.first.x, lost.first.y,
      lost.origin == OriginId{} ? "" : ", of this object");
}

std::string noisy_line(const render::RenderStatistics& statistics) {
  const std::uint64_t pixels = statistics.noisy_pixels;
  if (pixels == 0) return {};
  return fmt::format("{} {} more noise than `--max-noise` allows, after {} samples; `--aov noise` shows which", pixels,
                     pixels == 1 ? "pixel has" : "pixels have", render::kMostSamples);
}

}  // namespace isl::cli
