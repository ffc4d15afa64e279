#include "renderer/solvers/cells/extended_search.h"

#include "renderer/solvers/cells/stretch_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::render {

// A ray whose steps are spent asks in every cell that it meets. It gets no answer, for which nothing is set up.

std::optional<bool> is_inside(const LaidOutFields& fields, double t, RaySteps& steps) {
  if (steps.is_spent()) return std::nullopt;
  const std::optional<bool> inside = extended::is_inside_at(fields, t, steps);
  return inside ? inside : wide_extended::is_inside_at(fields, t, steps);
}

bool may_cross(const LaidOutFields& fields, double t0, double t1, RaySteps& steps) {
  return steps.is_spent() || extended::may_cross_on(fields, t0, t1, steps);
}

namespace {

ExtendedAnswer answer_from(const OpenStretch& stretch, const std::optional<long double>& crossing) {
  if (!crossing) return {true, std::nullopt};
  return {true, static_cast<double>(static_cast<long double>(stretch.t0) + *crossing)};
}

/// Asks with 113 bits where long double leaves a doubt: everywhere else its answer is proven.
class WideSearch {
 public:
  WideSearch(const LaidOutFields& fields, const OpenStretch& stretch, RaySteps& steps)
      : fields_(fields), stretch_(stretch), steps_(steps) {}

  [[nodiscard]] ExtendedAnswer settle(const StretchAnswer& known) const {
    if (steps_.is_spent()) return {};
    if (known.is_open || known.doubts.size() > kMostDoubts) return search(stretch_);
    for (const StretchAnswer::Part& doubt : known.doubts) {
      const OpenStretch near = around(doubt);
      const ExtendedAnswer answer = search(near);
      // A crossing at the very start of what is looked at may lie before.
      if (answer.crossing && *answer.crossing <= near.t0 && near.t0 > stretch_.t0) return search(stretch_);
      if (!answer.is_certain || answer.crossing) return answer;
    }
    if (known.is_placed) return answer_from(stretch_, known.crossing);
    if (known.bracket) {
      const std::optional<long double> crossing = wide_extended::crossing_in(fields_, stretch_, known, steps_);
      return crossing ? answer_from(stretch_, crossing) : ExtendedAnswer{};
    }
    const OpenStretch near = around({*known.crossing - known.slack / 2, *known.crossing + known.slack / 2});
    const ExtendedAnswer answer = search(near);
    return answer.crossing && *answer.crossing > near.t0 ? answer : search(stretch_);
  }

 private:
  /// Each sets up all fields anew.
  static constexpr std::size_t kMostDoubts = 8;

  /// A stretch at whose ends long double tells the sign, if it does not within the part.
  [[nodiscard]] OpenStretch around(const StretchAnswer::Part& part) const {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    OpenStretch near = stretch_;
    near.t0 = std::max(stretch_.t0, std::nextafter(stretch_.t0 + static_cast<double>(part.begin), -kNever));
    near.t1 = std::min(stretch_.t1, std::nextafter(stretch_.t0 + static_cast<double>(part.end), kNever));
    near.starts_on_root = stretch_.starts_on_root && near.t0 == stretch_.t0;
    return near;
  }

  [[nodiscard]] ExtendedAnswer search(const OpenStretch& stretch) const {
    const StretchAnswer answer = wide_extended::search_stretch(fields_, stretch, steps_);
    return answer.is_certain() ? answer_from(stretch, answer.crossing) : ExtendedAnswer{};
  }

  const LaidOutFields& fields_;
  const OpenStretch& stretch_;
  RaySteps& steps_;
};

}  // namespace

ExtendedAnswer search_extended(const LaidOutFields& fields, const OpenStretch& stretch, RaySteps& steps) {
  if (steps.is_spent()) return {};
  const StretchAnswer known = extended::search_stretch(fields, stretch, steps);
  if (known.is_certain()) return answer_from(stretch, known.crossing);
  return WideSearch(fields, stretch, steps).settle(known);
}

}  // namespace isl::render
