#include "cli/accuracy/page.h"

#include "cli/accuracy/chart.h"
#include "cli/accuracy/page_files.h"
#include "cli/output/version.h"
#include "renderer/image/transfer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace isl::cli {
namespace {

/// JSON inside a script element must not end it.
std::string json_for_script(const nlohmann::ordered_json& document) {
  std::string text;
  for (const char c : document.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
    if (c == '/' && text.ends_with('<')) text += '\\';
    text += c;
  }
  return text;
}

std::string table_rows(const AccuracyReport& report) {
  const std::vector<bool> front = pareto_front(report);
  std::string rows;
  for (std::size_t i = 0; i < report.rungs.size(); ++i) {
    const render::Measured& m = report.comparison.settings[i];
    const render::ErrorSummary& s = m.summary;
    rows += fmt::format(
        "<tr data-rung=\"{}\"><td>{}{}{}</td><td>{:.2f}</td><td>{:.2f}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td>{}</td><td>{}</td><td>{}</td>{}</tr>\n",
        i, html_text(report.rungs[i].setting.name()), report.rungs[i].setting.is_default() ? " (default)" : "",
        front[i] ? " ◯" : "", m.relative_time, m.evaluations_per_ray, length_text(s.median_pixels),
        length_text(s.p99_pixels), length_text(s.worst_pixels), s.beyond_pixel, s.missed, s.false_surfaces, s.holes,
        m.shadows ? fmt::format("<td>{}</td><td>{}</td>", m.shadows->leaks, m.shadows->false_shadows) : "");
  }
  return rows;
}

std::string css_colour(const render::Rgb& linear) {
  const auto code = [](double value) { return std::lround(255 * render::display_from_linear(value)); };
  return fmt::format("#{:02x}{:02x}{:02x}", code(linear.x), code(linear.y), code(linear.z));
}

/// A bar of the map with `labels` at equal steps under it, the first at its left end and the last at its right; labels
/// that would touch the one before are left out.
std::string legend(const char* name, const std::vector<std::string>& labels) {
  constexpr double kBarLeft = 20, kBarWidth = 400, kLetter = 7;
  std::string svg = fmt::format("<svg viewBox=\"0 0 440 34\"><defs><linearGradient id=\"{}\">", name);
  constexpr int kStops = 24;
  for (int i = 0; i <= kStops; ++i) {
    const double share = static_cast<double>(i) / kStops;
    svg += fmt::format("<stop offset=\"{:.4f}\" stop-color=\"{}\"/>", share, css_colour(render::false_colour(share)));
  }
  svg += fmt::format("</linearGradient></defs><rect x=\"{}\" y=\"4\" width=\"{}\" height=\"12\" fill=\"url(#{})\"/>",
                     kBarLeft, kBarWidth, name);
  double free = 0;  // the next label may begin here
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double x = kBarLeft + kBarWidth * static_cast<double>(i) / static_cast<double>(labels.size() - 1);
    const double half = 0.5 * kLetter * static_cast<double>(labels[i].size());
    if (i > 0 && x - half < free) continue;
    svg += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"29\" text-anchor=\"middle\">{}</text>", x, labels[i]);
    free = x + half + kLetter;
  }
  return svg + "</svg>";
}

std::vector<std::string> labels_of(const render::ColourScale& scale, double base) {
  const int steps = static_cast<int>(std::lround(std::log(scale.high / scale.low) / std::log(base)));
  std::vector<std::string> labels;
  for (int i = 0; i <= steps; ++i) labels.push_back(fmt::format("{:.6g}", scale.low * std::pow(base, i)));
  return labels;
}

}  // namespace

std::string accuracy_page(const AccuracyReport& report, const AccuracyPictures& pictures) {
  const nlohmann::ordered_json maps = {{"errors", pictures.errors}, {"costs", pictures.costs}};
  const bool has_shadows = report.comparison.settings.front().shadows.has_value();
  return fmt::format(fmt::runtime(kPageHtml), fmt::arg("title", html_text("Accuracy of " + report.scene)),
                     fmt::arg("style", kPageStyle), fmt::arg("advice", html_text(advice(report))),
                     fmt::arg("check", html_text(reference_sentence(report.comparison.reference))),
                     fmt::arg("width", report.size.width), fmt::arg("height", report.size.height),
                     fmt::arg("version", kVersion), fmt::arg("scene", pictures.scene),
                     fmt::arg("chart", chart_svg(report)), fmt::arg("last_setting", report.rungs.size() - 1),
                     fmt::arg("error_legend", legend("error-map", labels_of(pictures.scales.error, 10))),
                     fmt::arg("missed_colour", css_colour(render::kMissedColour)),
                     fmt::arg("false_colour", css_colour(render::kFalseColour)),
                     fmt::arg("undecided_colour", css_colour(render::kUndecidedColour)),
                     fmt::arg("nothing_colour", css_colour(render::kBackgroundColour)),
                     fmt::arg("cost_legend", legend("cost-map", labels_of(pictures.scales.cost, 2))),
                     fmt::arg("shadow_columns", has_shadows ? "<th>light leaks</th><th>false shadows</th>" : ""),
                     fmt::arg("rows", table_rows(report)), fmt::arg("command", html_text(report.command)),
                     fmt::arg("report", json_for_script(table_json(report))),
                     fmt::arg("pictures", json_for_script(maps)), fmt::arg("script", kPageScript));
}

}  // namespace isl::cli
