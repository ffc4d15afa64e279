#include "cli/accuracy_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace isl::cli {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// What settings are judged by: the worst error, worse than any length where surfaces are missed or invented, and none
/// better than the reference is known to be.
double worst_of(const AccuracyReport& report, std::size_t i) {
  const render::ErrorSummary& summary = report.comparison.settings[i].summary;
  if (summary.missed + summary.false_surfaces > 0) return kNever;
  return std::max(summary.worst_pixels, report.comparison.check.worst_pixels);
}

/// Settings that do the very same work, as hermite does where no ray needs its tolerance, are seen to differ by up to a
/// hundredth: where their memory lies decides that much.
constexpr double kSameTime = 0.02;

bool is_quicker(const render::Measured& a, const render::Measured& b) {
  return a.relative_time + std::max(a.time_spread + b.time_spread, kSameTime * b.relative_time) < b.relative_time;
}

/// Of two that are as quick and as exact: which one is to be named.
bool stands_for(const AccuracyReport& report, std::size_t a, std::size_t b) {
  return report.rungs[a].is_default || (a < b && !report.rungs[b].is_default);
}

/// Whether a leaves no reason to choose b.
bool beats(const AccuracyReport& report, std::size_t a, std::size_t b) {
  const render::Measured& left = report.comparison.settings[a];
  const render::Measured& right = report.comparison.settings[b];
  const double left_error = worst_of(report, a), right_error = worst_of(report, b);
  if (a == b || left_error > right_error || is_quicker(right, left)) return false;
  return left_error < right_error || is_quicker(left, right) || stands_for(report, a, b);
}

std::string count_text(std::uint64_t count) { return count == 0 ? "-" : fmt::format("{}", count); }

std::string length_text(double pixels) { return pixels == 0 ? "0" : fmt::format("{:.2g}", pixels); }

}  // namespace

std::vector<bool> pareto_front(const AccuracyReport& report) {
  const std::size_t count = report.rungs.size();
  std::vector<bool> front(count, true);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t other = 0; other < count; ++other) {
      if (beats(report, other, i)) front[i] = false;
    }
  }
  return front;
}

std::string advice(const AccuracyReport& report) {
  const std::vector<render::Measured>& settings = report.comparison.settings;
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < report.rungs.size(); ++i) {
    if (worst_of(report, i) > kAdvisedPixels) continue;
    if (!best || is_quicker(settings[i], settings[*best]) ||
        (!is_quicker(settings[*best], settings[i]) && stands_for(report, i, *best))) {
      best = i;
    }
  }
  if (!best) return fmt::format("No setting keeps every ray within {} of a pixel.", kAdvisedPixels);
  const double worst = worst_of(report, *best);
  return fmt::format("For this view, {}{} is the cheapest setting whose worst error is under a tenth of a pixel ({}).",
                     report.rungs[*best].options(), report.rungs[*best].is_default ? " (the default)" : "",
                     worst == 0 ? "none was found" : fmt::format("it is at most {} px", length_text(worst)));
}

std::string check_sentence(const render::ReferenceCheck& check) {
  const std::uint64_t checked = check.rays - check.unchecked;
  if (checked == 0) return "The reference has closed forms on this scene; interval arithmetic had no field to check.";
  std::string text =
      fmt::format("The reference was proven by interval arithmetic on {} of {} sampled rays", check.proven, checked);
  if (check.worst_pixels > 0) text += fmt::format(", to within {:.1g} px", check.worst_pixels);
  if (check.undecided > 0) text += fmt::format("; {} stayed undecided", check.undecided);
  if (check.refuted > 0) text += fmt::format("; {} WERE REFUTED: please report this scene", check.refuted);
  return text + ".";
}

std::string table_text(const AccuracyReport& report) {
  const std::vector<bool> front = pareto_front(report);
  std::string text =
      fmt::format("{:<18} {:>6} {:>9} {:>9} {:>9} {:>9} {:>7} {:>7} {:>7} {:>6}\n", "", "time", "fields/ray",
                  "median px", "99 % px", "worst px", "> 1 px", "missed", "false", "holes");
  for (std::size_t i = 0; i < report.rungs.size(); ++i) {
    const render::Measured& measured = report.comparison.settings[i];
    const render::ErrorSummary& s = measured.summary;
    text += fmt::format("{:<18} {:>6.2f} {:>10.2f} {:>9} {:>9} {:>9} {:>7} {:>7} {:>7} {:>6}{}{}\n",
                        report.rungs[i].name(), measured.relative_time, measured.evaluations_per_ray,
                        length_text(s.median_pixels), length_text(s.p99_pixels), length_text(s.worst_pixels),
                        count_text(s.beyond_pixel), count_text(s.missed), count_text(s.false_surfaces),
                        count_text(s.holes), front[i] ? " *" : "", report.rungs[i].is_default ? " default" : "");
  }
  text += fmt::format(
      "{}x{} camera rays; time relative to the default, median of rounds; * nothing is quicker and more exact\n",
      report.size.width, report.size.height);
  return text + check_sentence(report.comparison.check) + "\n" + advice(report) + "\n";
}

std::string table_csv(const AccuracyReport& report) {
  const std::vector<bool> front = pareto_front(report);
  std::string text =
      "setting,options,relative_time,time_spread,processor_seconds,rounds,field_evaluations_per_ray,solver_steps_per_"
      "ray,"
      "uncertified_steps,error_median_px,error_p99_px,error_worst_px,error_worst_units,beyond_pixel,missed,"
      "false_surfaces,holes,pareto\n";
  for (std::size_t i = 0; i < report.rungs.size(); ++i) {
    const render::Measured& m = report.comparison.settings[i];
    const render::ErrorSummary& s = m.summary;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", report.rungs[i].name(),
                        report.rungs[i].options(), m.relative_time, m.time_spread, m.processor_seconds, m.rounds,
                        m.evaluations_per_ray, m.solver_steps_per_ray, m.uncertified_steps, s.median_pixels,
                        s.p99_pixels, s.worst_pixels, s.worst_units, s.beyond_pixel, s.missed, s.false_surfaces,
                        s.holes, front[i] ? 1 : 0);
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
    settings.push_back({{"setting", rung.name()},
                        {"options", rung.options()},
                        {"family", rung.family},
                        {"default", rung.is_default},
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
  }
  const render::ReferenceCheck& check = report.comparison.check;
  return {{"scene", report.scene},
          {"command", report.command},
          {"size", {report.size.width, report.size.height}},
          {"settings", settings},
          {"reference",
           {{"options", "--solver exact"},
            {"rays", check.rays},
            {"proven", check.proven},
            {"undecided", check.undecided},
            {"refuted", check.refuted},
            {"unchecked", check.unchecked},
            {"within_px", check.worst_pixels}}},
          {"advice", advice(report)},
          {"seconds", report.comparison.seconds}};
}

}  // namespace isl::cli
