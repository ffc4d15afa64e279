#include "cli/accuracy/page.h"

#include "cli/accuracy/chart.h"
#include "cli/output/version.h"
#include "renderer/image/transfer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string_view>

namespace isl::cli {
namespace {

constexpr std::string_view kStyle = R"css(
:root { color-scheme: light; --ink: #16181d; --soft: #5d636e; --line: #dfe2e7; --mark: #b4232a; }
body { font: 15px/1.5 system-ui, sans-serif; color: var(--ink); background: #fff; margin: 2rem auto; max-width: 1120px;
       padding: 0 1rem; }
h1 { font-size: 1.5rem; margin: 0 0 .4rem; } h2 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
.advice { font-size: 1.1rem; } .soft, figcaption { color: var(--soft); font-size: .87rem; }
.two { display: grid; grid-template-columns: repeat(auto-fit, minmax(340px, 1fr)); gap: 1.5rem; align-items: start; }
figure { margin: 0; } img { width: 100%; image-rendering: pixelated; background: #1f1f1f; display: block; }
svg { width: 100%; height: auto; display: block; } #stage { position: relative; }
.grid { stroke: var(--line); } .tick { font-size: 11px; fill: var(--soft); } .axis { font-size: 12px; fill: var(--ink); }
.front { fill: none; stroke: #8b919c; stroke-dasharray: 4 3; }
.point { cursor: pointer; outline: none; } .point line { stroke: var(--ink); stroke-opacity: .35; stroke-width: 2; }
.disc { fill: var(--ink); } .hollow { fill: #fff; stroke: var(--ink); stroke-width: 2; }
.ring { fill: none; stroke: #16181d; stroke-width: 1.2; }
.point.chosen .disc, .point.chosen .hollow { stroke: var(--mark); stroke-width: 3; }
#tip { position: absolute; pointer-events: none; background: #16181d; color: #fff; border-radius: 4px; padding: .35rem .6rem;
       font-size: .82rem; white-space: nowrap; visibility: hidden; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; font-size: .87rem; }
th, td { padding: .25rem .6rem; text-align: right; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; } tbody tr { cursor: pointer; }
tbody tr:hover { background: #f3f5f8; } tr.chosen { background: #fbeeee; }
input[type=range] { width: 100%; accent-color: var(--mark); } code { background: #f3f5f8; padding: .15rem .4rem; }
pre { background: #f3f5f8; padding: .7rem 1rem; overflow-x: auto; } .key { display: inline-block; width: .8em; height: .8em; }
)css";

/// Hovering names the setting; choosing one, in the chart, the table or by the slider, shows its pictures.
constexpr std::string_view kScript = R"js(
const report = JSON.parse(document.getElementById('report').textContent);
const pictures = JSON.parse(document.getElementById('pictures').textContent);
const points = [...document.querySelectorAll('.point')], rows = [...document.querySelectorAll('tbody tr')];
const slider = document.getElementById('slider'), tip = document.getElementById('tip');
const number = x => x === 0 ? '0' : Math.abs(x) >= 0.01 && Math.abs(x) < 1e4 ? +x.toPrecision(3) + '' : x.toExponential(1);
function choose(i) {
  slider.value = i;
  for (const all of [points, rows]) all.forEach(e => e.classList.toggle('chosen', +e.dataset.rung === i));
  document.getElementById('error').src = pictures.errors[i];
  document.getElementById('cost').src = pictures.costs[i];
  document.getElementById('name').textContent = report.settings[i].options;
}
function show(point) {
  const s = report.settings[+point.dataset.rung];
  tip.textContent = '';
  const name = document.createElement('b');
  name.textContent = s.setting;
  tip.append(name, ': ' + number(s.relative_time) + ' × the time, worst ' + number(s.error.worst_px) + ' px, ' +
             s.missed + ' missed, ' + s.false_surfaces + ' false');
  const stage = document.getElementById('stage').getBoundingClientRect(), box = point.getBoundingClientRect();
  tip.style.left = Math.max(0, Math.min(box.left - stage.left + 16, stage.width - tip.offsetWidth)) + 'px';
  tip.style.top = Math.max(0, box.top - stage.top - tip.offsetHeight - 6) + 'px';
  tip.style.visibility = 'visible';
}
for (const point of points) {
  point.addEventListener('mouseenter', () => show(point));
  point.addEventListener('focus', () => show(point));
  for (const end of ['mouseleave', 'blur']) point.addEventListener(end, () => { tip.style.visibility = 'hidden'; });
}
for (const e of [...points, ...rows]) e.addEventListener('click', () => choose(+e.dataset.rung));
slider.addEventListener('input', () => choose(+slider.value));
choose(Math.max(0, report.settings.findIndex(s => s.default)));
)js";

/// JSON inside a script element must not end it.
std::string json_for_script(const nlohmann::ordered_json& document) {
  std::string text;
  for (const char c : document.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
    if (c == '/' && text.ends_with('<')) text += '\\';
    text += c;
  }
  return text;
}

std::string length_text(double pixels) { return pixels == 0 ? "0" : fmt::format("{:.2g}", pixels); }

std::string table_rows(const AccuracyReport& report) {
  const std::vector<bool> front = pareto_front(report);
  std::string rows;
  for (std::size_t i = 0; i < report.rungs.size(); ++i) {
    const render::Measured& m = report.comparison.settings[i];
    const render::ErrorSummary& s = m.summary;
    rows += fmt::format(
        "<tr data-rung=\"{}\"><td>{}{}{}</td><td>{:.2f}</td><td>{:.2f}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td>{}</td><td>{}</td><td>{}</td>{}</tr>\n",
        i, html_text(report.rungs[i].setting.name()), report.rungs[i].setting.is_default() ? " (default)" : "", front[i] ? " ◯" : "",
        m.relative_time, m.evaluations_per_ray, length_text(s.median_pixels), length_text(s.p99_pixels),
        length_text(s.worst_pixels), s.beyond_pixel, s.missed, s.false_surfaces, s.holes,
        m.shadows ? fmt::format("<td>{}</td><td>{}</td>", m.shadows->leaks, m.shadows->false_shadows) : "");
  }
  return rows;
}

std::string css_colour(const render::Rgb& linear) {
  const auto code = [](double value) { return std::lround(255 * render::display_from_linear(value)); };
  return fmt::format("#{:02x}{:02x}{:02x}", code(linear.x), code(linear.y), code(linear.z));
}

/// A bar of the map with `labels` at equal steps under it, the first at its left end and the last at its right; those that
/// would touch the one before are left out.
std::string legend(const char* name, const std::vector<std::string>& labels) {
  constexpr double kLeft = 20, kWidth = 400, kLetter = 7;
  std::string svg = fmt::format("<svg viewBox=\"0 0 440 34\"><defs><linearGradient id=\"{}\">", name);
  constexpr int kStops = 24;
  for (int i = 0; i <= kStops; ++i) {
    const double share = static_cast<double>(i) / kStops;
    svg += fmt::format("<stop offset=\"{:.4f}\" stop-color=\"{}\"/>", share, css_colour(render::false_colour(share)));
  }
  svg += fmt::format("</linearGradient></defs><rect x=\"{}\" y=\"4\" width=\"{}\" height=\"12\" fill=\"url(#{})\"/>",
                     kLeft, kWidth, name);
  double free = 0;  // where the next one may begin
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double x = kLeft + kWidth * static_cast<double>(i) / static_cast<double>(labels.size() - 1);
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

std::string pictures_section(const AccuracyReport& report, const AccuracyPictures& pictures) {
  return fmt::format(
      R"(<h2>Where it errs, where it costs: <code id="name"></code></h2>
<input id="slider" type="range" min="0" max="{}" step="1" aria-label="setting">
<div class="two">
<figure><img id="error" alt="errors of the chosen setting">{}<figcaption>Error along the ray, in pixels.
<span class="key" style="background:{}"></span> missed <span class="key" style="background:{}"></span> false surface
<span class="key" style="background:{}"></span> nothing there</figcaption></figure>
<figure><img id="cost" alt="costs of the chosen setting">{}<figcaption>Field evaluations of the ray.</figcaption></figure>
</div>
)",
      report.rungs.size() - 1, legend("error-map", labels_of(pictures.scales.error, 10)),
      css_colour(render::kMissedColour), css_colour(render::kFalseColour), css_colour(render::kBackgroundColour),
      legend("cost-map", labels_of(pictures.scales.cost, 2)));
}

}  // namespace

std::string accuracy_page(const AccuracyReport& report, const AccuracyPictures& pictures) {
  const std::string title = html_text("Accuracy of " + report.scene);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{}</title>\n<link rel=\"icon\" "
      "href=\"data:,\"><meta name=\"viewport\" content=\"width=device-width\"><style>{}</style></head><body>\n",
      title, kStyle);
  page += fmt::format(
      "<h1>{}</h1>\n<p class=\"advice\">{}</p>\n<p class=\"soft\">{} {}x{} camera rays through the pixels' "
      "middles; isl {}.</p>\n",
      title, html_text(advice(report)), html_text(check_sentence(report.comparison.check)), report.size.width,
      report.size.height, kVersion);
  page += fmt::format(
      "<div class=\"two\"><figure><img id=\"picture\" src=\"{}\" alt=\"the scene\"><figcaption>The scene with the "
      "default "
      "setting.</figcaption></figure>\n<figure><div id=\"stage\">{}<div id=\"tip\"></div></div><figcaption>Down and "
      "left is "
      "better. Ringed and joined: the Pareto front, nothing is both quicker and more exact. Hollow: some surfaces are "
      "missed or "
      "invented. At the bottom: nothing that the reference could tell.</figcaption></figure></div>\n",
      pictures.scene, chart_svg(report));
  page += pictures_section(report, pictures);
  page += fmt::format(
      "<h2>All settings</h2>\n<table><thead><tr><th>setting</th><th>time</th><th>fields/ray</th><th>median "
      "px</th><th>99 % "
      "px</th><th>worst px</th><th>&gt; 1 "
      "px</th><th>missed</th><th>false</th><th>holes</th>{}</tr></thead><tbody>\n{}</tbody>"
      "</table>\n<p class=\"soft\">Time is processor time relative to the default, the median of interleaved rounds. "
      "Errors are "
      "lengths along the ray, in pixels of its footprint.</p>\n",
      report.comparison.settings.front().shadows ? "<th>light leaks</th><th>false shadows</th>" : "",
      table_rows(report));
  page += fmt::format("<h2>Made by</h2>\n<pre>{}</pre>\n", html_text(report.command));
  page +=
      fmt::format("<script type=\"application/json\" id=\"report\">{}</script>\n", json_for_script(table_json(report)));
  page += fmt::format("<script type=\"application/json\" id=\"pictures\">{}</script>\n",
                      json_for_script({{"errors", pictures.errors}, {"costs", pictures.costs}}));
  page += fmt::format("<script>{}</script>\n</body></html>\n", kScript);
  return page;
}

}  // namespace isl::cli
