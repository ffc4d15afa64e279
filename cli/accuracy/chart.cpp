#include "cli/accuracy/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace isl::cli {
namespace {

// All lengths are in SVG units. The right margin has room for the methods' names.
constexpr double kWidth = 640, kHeight = 440, kLeft = 64, kRight = 104, kTop = 14, kBottom = 46;

constexpr std::array kFamilyColours{"#d5622c", "#2563c4", "#16181d", "#2a8c55", "#9440b0", "#b58a00",
                                    "#0f8c9c", "#c02860", "#6b6f78", "#7a4a1e", "#5b8f1d"};

/// A logarithmic axis: maps an interval of values to an interval of places.
struct Axis {
  double low, high, from, to;

  [[nodiscard]] double place(double value) const {
    return from + (to - from) * std::log(std::clamp(value, low, high) / low) / std::log(high / low);
  }
};

struct Plot {
  Axis time, error;
  double floor;  ///< smaller errors are drawn here
};

double worst_shown(const AccuracyReport& report, std::size_t i, double floor) {
  return std::max(report.comparison.settings[i].summary.worst_pixels, floor);
}

Plot plot_of(const AccuracyReport& report) {
  const auto& settings = report.comparison.settings;
  const double least = resolution(report);
  double greatest = 1, least_time = 1, greatest_time = 1;
  for (const render::Measured& measured : settings) {
    greatest = std::max(greatest, measured.summary.worst_pixels);
    least_time = std::min(least_time, measured.relative_time);
    greatest_time = std::max(greatest_time, measured.relative_time);
  }
  // If no field could be judged (solids), the floor is the spacing of doubles in a picture of a thousand pixels.
  const double floor = std::pow(10, std::floor(std::log10(least > 0 ? least : 1e-12)));
  const double top = std::pow(10, std::ceil(std::log10(greatest * 1.5)));
  return {{least_time / 1.5, greatest_time * 1.5, kLeft, kWidth - kRight},
          {floor / 3, top, kHeight - kBottom, kTop},
          floor};
}

std::string power_text(int exponent) {
  if (exponent >= -2 && exponent <= 2) return fmt::format("{:g}", std::pow(10, exponent));
  return fmt::format("10<tspan dy=\"-5\" font-size=\"9\">{}{}</tspan>", exponent < 0 ? "−" : "", std::abs(exponent));
}

std::string axes(const Plot& plot) {
  std::string svg;
  const int first = static_cast<int>(std::round(std::log10(plot.floor)));
  const int last = static_cast<int>(std::round(std::log10(plot.error.high)));
  const int step = last - first > 8 ? 2 : 1;
  for (int exponent = first; exponent <= last; exponent += step) {
    const double y = plot.error.place(std::pow(10, exponent));
    svg += fmt::format("<line class=\"grid\" x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>", kLeft, kWidth - kRight,
                       y, y);
    svg += fmt::format("<text class=\"tick\" x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}{}</text>\n", kLeft - 8, y + 4,
                       exponent == first ? "≤ " : "", power_text(exponent));
  }
  for (double decade = 1e-3; decade < 1e6; decade *= 10) {
    for (const double part : {1.0, 2.0, 5.0}) {
      const double value = decade * part;
      if (value < plot.time.low || value > plot.time.high) continue;
      const double x = plot.time.place(value);
      svg += fmt::format("<line class=\"grid\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{}\" y2=\"{}\"/>", x, x, kTop,
                         kHeight - kBottom);
      svg += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:g}</text>\n", x,
                         kHeight - kBottom + 17, value);
    }
  }
  svg += fmt::format(
      "<text class=\"axis\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">time, relative to the default</text>\n",
      (kLeft + kWidth - kRight) / 2, kHeight - 8);
  svg += fmt::format(
      "<text class=\"axis\" transform=\"translate(14 {}) rotate(-90)\" text-anchor=\"middle\">error in pixels: "
      "from the worst down to the median</text>\n",
      (kTop + kHeight - kBottom) / 2);
  return svg;
}

/// Rungs of the front from quick to slow, joined by steps: settings to the right of and above the line are dominated.
std::string front_line(const AccuracyReport& report, const Plot& plot, const std::vector<bool>& front) {
  std::vector<std::size_t> rungs;
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (front[i]) rungs.push_back(i);
  }
  std::ranges::sort(rungs, {}, [&](std::size_t i) { return report.comparison.settings[i].relative_time; });
  std::string path;
  for (const std::size_t i : rungs) {
    const double x = plot.time.place(report.comparison.settings[i].relative_time);
    const double y = plot.error.place(worst_shown(report, i, plot.floor));
    path += path.empty() ? fmt::format("M{:.1f} {}V{:.1f}", x, kTop, y) : fmt::format("H{:.1f}V{:.1f}", x, y);
  }
  if (!path.empty()) path += fmt::format("H{}", kWidth - kRight);
  return fmt::format("<path class=\"front\" d=\"{}\"/>\n", path);
}

std::vector<std::string> families_of(const AccuracyReport& report) {
  std::vector<std::string> families;
  for (const Rung& rung : report.rungs) {
    if (std::ranges::find(families, rung.setting.family()) == families.end()) families.push_back(rung.setting.family());
  }
  return families;
}

std::string point(const AccuracyReport& report, const Plot& plot, std::size_t i, const char* colour, bool on_front) {
  const render::Measured& measured = report.comparison.settings[i];
  const double x = plot.time.place(measured.relative_time);
  const double worst = plot.error.place(worst_shown(report, i, plot.floor));
  const double median = plot.error.place(std::max(measured.summary.median_pixels, plot.floor));
  const bool is_whole = measured.summary.missed + measured.summary.false_surfaces == 0;
  std::string svg = fmt::format("<g class=\"point\" data-rung=\"{}\" tabindex=\"0\" style=\"--ink:{}\">", i, colour);
  svg += fmt::format("<title>{}</title>", html_text(report.rungs[i].setting.name()));
  svg += fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>", x, worst, median);
  if (on_front) svg += fmt::format("<circle class=\"ring\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"9\"/>", x, worst);
  svg += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"/></g>\n", is_whole ? "disc" : "hollow",
                     x, worst);
  return svg;
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '>': escaped += "&gt;"; break;
      case '"': escaped += "&quot;"; break;
      default: escaped += c;
    }
  }
  return escaped;
}

std::string chart_svg(const AccuracyReport& report) {
  const Plot plot = plot_of(report);
  const std::vector<bool> front = pareto_front(report);
  const std::vector<std::string> families = families_of(report);
  std::string svg = fmt::format(
      "<svg id=\"chart\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"error against time of every setting\">\n",
      kWidth, kHeight);
  svg += axes(plot) + front_line(report, plot, front);
  for (std::size_t i = 0; i < report.rungs.size(); ++i) {
    const auto family = std::ranges::find(families, report.rungs[i].setting.family()) - families.begin();
    const char* colour = kFamilyColours[static_cast<std::size_t>(family) % kFamilyColours.size()];
    svg += point(report, plot, i, colour, front[i]);
  }
  for (std::size_t i = 0; i < families.size(); ++i) {
    const double y = kTop + 16 + 16 * static_cast<double>(i);
    svg += fmt::format(
        "<circle cx=\"{}\" cy=\"{}\" r=\"5\" fill=\"{}\"/><text class=\"tick\" x=\"{}\" y=\"{}\">{}</text>\n",
        kWidth - 92, y, kFamilyColours[i % kFamilyColours.size()], kWidth - 82, y + 4, html_text(families[i]));
  }
  return svg + "</svg>\n";
}

}  // namespace isl::cli
