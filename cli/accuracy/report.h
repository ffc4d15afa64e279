// The results of `isl accuracy` in words and numbers: the table for a terminal, the same as CSV and JSON, and the
// advice.
#pragma once

#include "cli/accuracy/ladder.h"
#include "renderer/accuracy/comparison.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace isl::cli {

struct AccuracyReport {
  std::string scene;    ///< as the user named it
  std::string command;  ///< command line that makes this report again
  PictureSize size;
  std::vector<Rung> rungs;
  render::Comparison comparison;  ///< settings[i] belongs to rungs[i]
};

/// The worst error that the advice allows: a tenth of a pixel is less than antialiasing can show.
inline constexpr double kAdvisedPixels = 0.1;

/// Errors below this, in pixels, are equal: eight roundings of a place in double precision, and of what the reference
/// leaves open. 0 if no surface was judged.
[[nodiscard]] inline double resolution(const AccuracyReport& report) {
  return 8 * report.comparison.reference.worst_pixels;
}

/// A length in pixels, with two digits.
[[nodiscard]] std::string length_text(double pixels);

/// Rungs of the Pareto front, at least one: no other rung is both at least as quick and at least as exact, and better
/// in one of the two. Errors are the worst; a setting with missed or false surfaces is less exact than all without.
/// Times are equal within each other's spread or two hundredths, and so are errors below the resolution;
/// the default, or else the first, represents equals.
[[nodiscard]] std::vector<bool> pareto_front(const AccuracyReport& report);

/// One sentence: the cheapest setting whose worst error is within kAdvisedPixels and that misses and invents nothing;
/// the default if it is as quick as any.
[[nodiscard]] std::string advice(const AccuracyReport& report);

/// One sentence on how much of the truth is known.
[[nodiscard]] std::string reference_sentence(const render::ReferenceSummary& reference);

[[nodiscard]] std::string table_text(const AccuracyReport& report);
[[nodiscard]] std::string table_csv(const AccuracyReport& report);
[[nodiscard]] nlohmann::ordered_json table_json(const AccuracyReport& report);

}  // namespace isl::cli
