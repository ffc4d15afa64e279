// The chart of a report: error against time, both logarithmic, as plain SVG.
#pragma once

#include "cli/accuracy/report.h"

#include <string>
#include <string_view>

namespace isl::cli {

/// An <svg> element. Every setting is one element of the class `point` with its number in `data-rung`: the disc is its
/// worst error, the line below it reaches to the median. Settings that miss or invent surfaces are drawn hollow. Errors
/// below the reference's proven error are drawn at the bottom. Settings of the Pareto front are ringed and joined.
[[nodiscard]] std::string chart_svg(const AccuracyReport& report);

/// Escapes the text's characters that have a meaning in HTML.
[[nodiscard]] std::string html_text(std::string_view text);

}  // namespace isl::cli
