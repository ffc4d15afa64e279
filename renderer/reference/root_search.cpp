#include "renderer/reference/root_search.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

/// A thousand times as many as the hardest rays of pictures take; some seconds with eight components.
constexpr int kMostSteps = 1 << 18;

}  // namespace

void RootSearch::search(Real t0, Real t1) {
  if (!(t0 < t1)) return;
  std::vector<Piece> open{{t0, t1, field_.all(), false}};
  while (!open.empty() && !is_done()) {
    Piece piece = std::move(open.back());
    open.pop_back();
    if (++steps_ > kMostSteps) return doubt(piece.t0, t1);
    const LineStretch stretch = stretch_between(piece.t0, piece.t1);
    const JetPair f = field_.on(piece.active, stretch);
    const Interval& values = f.over.value;
    const Real cut = stretch.middle;
    const int sign = values.sign() != 0 ? values.sign() : f.ends.sign();
    if (sign != 0) {
      constant(sign);
      continue;
    }
    if (f.over.slope.sign() != 0) {
      confine(piece, stretch, f);
      continue;
    }
    // Rounding at the middle may be as large as all values because of a tip just there. So the halves are looked at.
    const bool is_lost = f.middle.value.sign() == 0 && values.radius() <= 16 * f.middle.value.radius();
    if ((is_lost && piece.is_of_lost) || !(piece.t0 < cut && cut < piece.t1) ||
        piece.t1 - piece.t0 <= 16 * kRoundoff * std::max(abs(piece.t0), abs(piece.t1))) {
      doubt(piece.t0, piece.t1);
      continue;
    }
    open.push_back({cut, piece.t1, piece.active, is_lost});
    open.push_back({piece.t0, cut, std::move(piece.active), is_lost});
  }
}

/// On the piece F is monotone. All its zeros are within c − F(c)/F′ for any c; for a narrower stretch about c, F′ is
/// known from F′(c) and the bend, so that a step squares the width. As long as the sign of F(c) is known, a step leaves
/// half of the stretch at most.
void RootSearch::confine(const Piece& piece, const LineStretch& stretch, const JetPair& f) {
  Interval slope = f.over.slope;
  const int sign = slope.sign();
  Jet here = f.middle;
  Real c = stretch.middle, low = piece.t0, high = piece.t1;
  for (bool is_shrinking = true; is_shrinking;) {
    const Interval zeros = Interval(c) - here.value / slope;
    const Real left = std::max(low, zeros.lo()), right = std::min(high, zeros.hi());
    if (left > right) return constant(here.value.sign());
    is_shrinking = right - left < (high - low) * 0.75L && ++steps_ < kMostSteps;
    low = left;
    high = right;
    const LineStretch rest = stretch_between(low, high);
    c = rest.middle;
    if (!is_shrinking) break;
    here = field_.at(piece.active, c);
    slope = common(slope, here.slope + f.over.bend * Interval::around(0, rest.reach));
  }
  if (low > piece.t0) constant(-sign);
  doubt(low, high);
  if (high < piece.t1) constant(sign);
}

void RootSearch::constant(int sign) {
  if (doubt_) {
    const Real half = (doubt_->end - doubt_->begin) / 2;
    if (sign_ == 0 || sign_ == sign) {
      roots_.touches.push_back(*doubt_);
    } else {
      roots_.crossings.push_back({doubt_->begin + half, half, sign > 0});
    }
    doubt_.reset();
  }
  if (is_done()) return;
  if (sign_ == 0) roots_.starts_inside = sign > 0;
  sign_ = sign;
}

void RootSearch::doubt(Real t0, Real t1) {
  if (!doubt_) doubt_ = Touch{t0, t1};
  doubt_->end = t1;
}

RayRoots RootSearch::finish() {
  if (doubt_) roots_.touches.push_back(*doubt_);
  return std::move(roots_);
}

}  // namespace isl::ISL_REFERENCE
