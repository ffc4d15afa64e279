#include "cli/accuracy/report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

namespace isl::cli {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// The error by which settings are judged: the worst one, infinite if surfaces are missed or invented, and at least the
/// resolution.
double worst_of(const AccuracyReport& report, std::size_t i) {
  const render::ErrorSummary& summary = report.comparison.settings[i].summary;
  if (summary.missed + summary.false_surfaces > 0) return kNever;
  return std::max(summary.worst_pixels, resolution(report));
}

/// Settings that do identical work, as hermite does if no ray needs its tolerance, differ by up to a hundredth in
/// measurements, because their memory lies elsewhere.
constexpr double kSameTime = 0.02;

bool is_quicker(const render::Measured& a, const render::Measured& b) {
  return a.relative_time + std::max(a.time_spread + b.time_spread, kSameTime * b.relative_time) < b.relative_time;
}

/// The rungs that are as quick as the quickest among `rungs`. All are compared with the quickest alone, because being
/// as quick is not transitive.
std::vector<std::size_t> quickest(const AccuracyReport& report, const std::vector<std::size_t>& rungs) {
  const std::vector<render::Measured>& settings = report.comparison.settings;
  const std::size_t first =
      *std::ranges::min_element(rungs, {}, [&](std::size_t i) { return settings[i].relative_time; });
  std::vector<std::size_t> result;
  for (const std::size_t i : rungs) {
    if (!is_quicker(settings[first], settings[i])) result.push_back(i);
  }
  return result;
}

/// The rung that is shown for a group of equals: the default if it is among them, else the first.
std::size_t representative(const AccuracyReport& report, const std::vector<std::size_t>& rungs) {
  const auto found = std::ranges::find_if(rungs, [&](std::size_t i) { return report.rungs[i].setting.is_default(); });
  return found == rungs.end() ? rungs.front() : *found;
}

/// The rungs among `rungs` for which `wanted(i)` holds.
template <class Wanted>
std::vector<std::size_t> chosen(const std::vector<std::size_t>& rungs, const Wanted& wanted) {
  std::vector<std::size_t> result;
  std::ranges::copy_if(rungs, std::back_inserter(result), wanted);
  return result;
}

std::vector<std::size_t> all_rungs(const AccuracyReport& report) {
  std::vector<std::size_t> all(report.rungs.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::string count_text(std::uint64_t count) { return count == 0 ? "-" : fmt::format("{}", count); }

std::string shadow_text(const render::Measured& measured) {
  if (!measured.shadows) return {};
  return fmt::format(" {:>7} {:>7}", count_text(measured.shadows->leaks), count_text(measured.shadows->false_shadows));
}

}  // namespace

std::string length_text(double pixels) { return pixels == 0 ? "0" : fmt::format("{:.2g}", pixels); }

std::vector<bool> pareto_front(const AccuracyReport& report) {
  std::vector<bool> front(report.rungs.size());
  // From quick to slow: the most exact of the quickest, then those that are more exact than that.
  for (std::vector<std::size_t> left = all_rungs(report); !left.empty();) {
    const std::vector<std::size_t> group = quickest(report, left);
    double least = kNever;
    for (const std::size_t i : group) least = std::min(least, worst_of(report, i));
    front[representative(report, chosen(group, [&](std::size_t i) { return worst_of(report, i) == least; }))] = true;
    left = chosen(left, [&](std::size_t i) { return worst_of(report, i) < least; });
  }
  return front;
}

std::string advice(const AccuracyReport& report) {
  const std::vector<std::size_t> good =
      chosen(all_rungs(report), [&](std::size_t i) { return worst_of(report, i) <= kAdvisedPixels; });
  if (good.empty()) return fmt::format("No setting keeps every ray within {} of a pixel.", kAdvisedPixels);
  const std::size_t best = representative(report, quickest(report, good));
  const double worst = worst_of(report, best);
  return fmt::format("For this view, {}{} is the cheapest setting whose worst error is under a tenth of a pixel ({}).",
                     report.rungs[best].setting.options(),
                     report.rungs[best].setting.is_default() ? " (the default)" : "",
                     worst == 0 ? "none was found" : fmt::format("it is at most {} px", length_text(worst)));
}

std::string reference_sentence(const render::ReferenceSummary& reference) {
  std::string text =
      fmt::format("The truth was proven in extended precision, independently of all solvers, on {} of {} rays",
                  reference.proven, reference.rays);
  if (reference.worst_pixels > 0) text += fmt::format(", to within {:.1g} px", reference.worst_pixels);
  if (reference.trusted > 0)
    text += fmt::format("; {} meet a solid or a combination, whose place is taken from `exact`", reference.trusted);
  if (reference.undecided > 0) text += fmt::format("; {} touch a surface and are left undecided", reference.undecided);
  return text + ".";
}

std::string table_text(const AccuracyReport& report) {
  const std::vector<bool> front = pareto_front(report);
  std::string text =
      fmt::format("{:<18} {:>6} {:>9} {:>9} {:>9} {:>9} {:>7} {:>7} {:>7} {:>6}\n", "", "time", "fields/ray",
                  "median px", "99 % px", "worst px", "> 1 px", "missed", "false", "holes");
  const bool has_shadows = report.comparison.settings.front().shadows.has_value();
  if (has_shadows) text.insert(text.size() - 1, fmt::format(" {:>7} {:>7}", "leaks", "false s"));
  for (std::size_t i = 0; i < report.rungs.size(); ++i) {
    const render::Measured& measured = report.comparison.settings[i];
    const render::ErrorSummary& s = measured.summary;
    text += fmt::format("{:<18} {:>6.2f} {:>10.2f} {:>9} {:>9} {:>9} {:>7} {:>7} {:>7} {:>6}{}{}{}\n",
                        report.rungs[i].setting.name(), measured.relative_time, measured.evaluations_per_ray,
                        length_text(s.median_pixels), length_text(s.p99_pixels), length_text(s.worst_pixels),
                        count_text(s.beyond_pixel), count_text(s.missed), count_text(s.false_surfaces),
                        count_text(s.holes), shadow_text(measured), front[i] ? " *" : "",
                        report.rungs[i].setting.is_default() ? " default" : "");
  }
  text += fmt::format(
      "{}x{} camera rays; time relative to the default, median of rounds; * no setting is both quicker and more "
      "exact\n",
      report.size.width, report.size.height);
  if (has_shadows) {
    text += fmt::format(
        "times include {} shadow rays; leaks: light in place of shadow, false s: shadow in place of light\n",
        report.comparison.settings.front().shadows->rays);
  }
  return text + reference_sentence(report.comparison.reference) + "\n" + advice(report) + "\n";
}

std::string table_csv(const AccuracyReport& report) {
  const std::vector<bool> front = pareto_front(report);
  std::string text =
      "setting,options,relative_time,time_spread,processor_seconds,rounds,field_evaluations_per_ray,solver_steps_per_"
      "ray,"
      "uncertified_steps,error_median_px,error_p99_px,error_worst_px,error_worst_units,beyond_pixel,missed,"
      "false_surfaces,holes,shadow_rays,leaks,false_shadows,pareto\n";
  for (std::size_t i = 0; i < report.rungs.size(); ++i) {
    const render::Measured& m = report.comparison.settings[i];
    const render::ErrorSummary& s = m.summary;
    const render::ShadowSummary shadows = m.shadows.value_or(render::ShadowSummary{});
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", report.rungs[i].setting.name(),
                    report.rungs[i].setting.options(), m.relative_time, m.time_spread, m.processor_seconds, m.rounds,
                    m.evaluations_per_ray, m.solver_steps_per_ray, m.uncertified_steps, s.median_pixels, s.p99_pixels,
                    s.worst_pixels, s.worst_units, s.beyond_pixel, s.missed, s.false_surfaces, s.holes, shadows.rays,
                    shadows.leaks, shadows.false_shadows, front[i] ? 1 : 0);
  }
  return text;
}

nlohmann::ordered_json table_json(const AccuracyReport& report) {
  const std::vector<bool> front = pareto_front(report);
  auto settings = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < report.rungs.size(); ++i) {
    const Rung& rung = report.rungs[i];
    const render::Measured& m = report.comparison.settings[i];
    const render::ErrorSummary& s = m.summary;
    settings.push_back({{"setting", rung.setting.name()},
                        {"options", rung.setting.options()},
                        {"family", rung.setting.family()},
                        {"default", rung.setting.is_default()},
                        {"relative_time", m.relative_time},
                        {"time_spread", m.time_spread},
                        {"processor_seconds", m.processor_seconds},
                        {"rounds", m.rounds},
                        {"field_evaluations_per_ray", m.evaluations_per_ray},
                        {"solver_steps_per_ray", m.solver_steps_per_ray},
                        {"uncertified_steps", m.uncertified_steps},
                        {"error",
                         {{"median_px", s.median_pixels},
                          {"p99_px", s.p99_pixels},
                          {"worst_px", s.worst_pixels},
                          {"worst_units", s.worst_units},
                          {"beyond_pixel", s.beyond_pixel}}},
                        {"missed", s.missed},
                        {"false_surfaces", s.false_surfaces},
                        {"holes", s.holes},
                        {"pareto", static_cast<bool>(front[i])}});
    if (m.shadows) {
      settings.back()["shadows"] = {
          {"rays", m.shadows->rays}, {"leaks", m.shadows->leaks}, {"false_shadows", m.shadows->false_shadows}};
    }
  }
  const render::ReferenceSummary& reference = report.comparison.reference;
  return {{"scene", report.scene},
          {"command", report.command},
          {"size", {report.size.width, report.size.height}},
          {"settings", settings},
          {"reference",
           {{"rays", reference.rays},
            {"proven", reference.proven},
            {"trusted", reference.trusted},
            {"undecided", reference.undecided},
            {"within_px", reference.worst_pixels}}},
          {"advice", advice(report)},
          {"seconds", report.comparison.seconds}};
}

}  // namespace isl::cli
