#include "renderer/extended/root_search.h"

#include <algorithm>

namespace isl::ISL_EXTENDED {
namespace {

/// Number of halvings after which a stretch is below the last bit of any t. It is reached only next to t = 0.
constexpr int kMaxDepth = 250;

class RootSearch {
 public:
  RootSearch(const FieldOnRay& field, Real enough) : field_(field), enough_(enough) {}

  /// Searches [t0, t1] on the field's components `from`. The signs are those of F at the ends, 0 if unknown.
  void isolate(const FieldOnRay::Active& from, Real t0, int sign0, Real t1, int sign1) {
    if (t0 < t1) isolate(field_.piece(from, t0, t1), sign0, sign1, 0);
  }

  /// Searches a piece from front to back: what lies behind the first crossing is never looked at.
  void isolate(FieldOnRay::Piece piece, int sign0, int sign1, int depth) {
    const Real t0 = piece.t0, t1 = piece.t1;
    if (is_done() || !(t0 < t1)) return;
    const FieldRange range = field_.over(piece);
    if (range.value.sign() != 0) return constant(range.value.sign());
    if (const int slope = range.derivative.sign(); slope != 0) {
      if (sign0 == slope) return constant(sign0);
      if (sign1 == -slope) return constant(sign1);
      // Where F was before the stretches in doubt that end here says as much as its sign here.
      if (sign1 == slope && (sign0 != 0 || sign_ == -slope)) return crossing(piece.active, t0, t1, sign0, slope);
    }
    if (depth > kMaxDepth || t1 - t0 <= 16 * kRoundoff * std::max(abs(t0), abs(t1))) return doubt(t0, t1);
    // Finds a cut where the sign is certain, with five tries, since a root may lie on one of them.
    Real cut = t0;
    Interval value;
    FieldOnRay::Samples samples;
    for (const Real fraction : {0.5L, 0.46L, 0.55L, 0.41L, 0.6L}) {
      cut = t0 + (t1 - t0) * fraction;
      value = field_.at(piece.active, cut, samples).value;
      if (value.sign() != 0) break;
    }
    if (is_done()) return;
    if (value.sign() == 0 && range.value.width() <= 16 * value.width()) return doubt(t0, t1);
    FieldOnRay::Piece before{t0, cut, piece.active, std::move(piece.first), samples};
    isolate(std::move(before), sign0, value.sign(), depth + 1);
    if (is_done()) return;
    FieldOnRay::Piece after{cut, t1, std::move(piece.active), std::move(samples), std::move(piece.last)};
    isolate(std::move(after), value.sign(), sign1, depth + 1);
  }

  /// Records that F keeps this sign on the next stretch.
  void constant(int sign) {
    settle_doubt(sign);
    if (sign_ == 0) root_.starts_inside = sign > 0;
    sign_ = sign;
  }

  /// Records that the next stretch is undecided.
  void doubt(Real t0, Real t1) {
    if (doubt_) {
      doubt_->end = t1;
    } else {
      doubt_ = Touch{t0, t1};
    }
  }

  /// Finds the crossing by Newton's method in a bracket, until the value is lost in its own rounding error, or Newton's
  /// steps are as short as is asked or as t tells apart and a place just beyond the root has the other sign.
  void refine(const FieldOnRay::Active& active, const Bracket& bracket, Real t, int sign0) {
    Real t0 = bracket.begin, t1 = bracket.end;
    const auto cross = [&](Real slack) {
      root_.crossing = t;
      root_.slack = slack;
      root_.bracket = {t0, t1};
    };
    for (int step = 0;; ++step) {
      const FieldRange here = field_.at(active, t);
      const Real slope = here.derivative.middle(), least = std::max(enough_, kRounding * std::max(abs(t0), abs(t1)));
      if (here.value.sign() == 0) return cross(std::min(t1 - t0, here.value.width() / abs(slope)));
      if (t1 - t0 <= least || step > 300) return cross(t1 - t0);
      const bool is_before = here.value.sign() == sign0;
      (is_before ? t0 : t1) = t;
      const Real newton = t - here.value.middle() / slope;
      if (abs(newton - t) <= least) {
        // Beyond the root by a few of these lengths the sign is certain again, unless F is very flat there.
        for (Real beyond = 4 * least; beyond < 0x1p20L * least; beyond *= 8) {
          const Real other = is_before ? t + beyond : t - beyond;
          if (other <= t0 || other >= t1 || field_.at(active, other).value.sign() == -here.value.sign())
            return cross(beyond);
        }
      }
      // Newton's steps double the digits where F is nearly straight; where they are slow, every other one halves.
      const bool is_slow = step > 8 && step % 2 == 0;
      t = !is_slow && newton > t0 && newton < t1 ? newton : t0 + (t1 - t0) / 2;
    }
  }

  [[nodiscard]] FirstRoot finish() {
    if (doubt_) root_.touches.push_back(*doubt_);
    return std::move(root_);
  }

 private:
  [[nodiscard]] bool is_done() const { return root_.crossing || field_.is_spent(); }

  /// Records a crossing: F is monotone on [t0, t1], in the direction `slope`, and certainly has its sign at t1. It has
  /// the other one at t0 or, if its sign there is unknown, had it before.
  void crossing(const FieldOnRay::Active& active, Real t0, Real t1, int sign0, int slope) {
    if (sign0 != 0) constant(sign0);
    if (is_done()) return;
    refine(active, {t0, t1}, t0 + (t1 - t0) / 2, -slope);
    doubt_.reset();
    sign_ = slope;
  }

  /// Decides an undecided stretch before one of known sign: a touch, or a crossing that cannot be located any better.
  void settle_doubt(int next_sign) {
    if (!doubt_) return;
    const Touch doubt = *doubt_;
    doubt_.reset();
    if (sign_ == 0 || sign_ == next_sign) {
      root_.touches.push_back(doubt);
    } else {
      root_.slack = doubt.end - doubt.begin;
      root_.crossing = doubt.begin + root_.slack / 2;
    }
  }

  const FieldOnRay& field_;
  Real enough_;
  FirstRoot root_;
  int sign_ = 0;  ///< the sign of F where it was decided last
  std::optional<Touch> doubt_;
};

/// Leaves the root at t = 0. Returns the t up to which F keeps the sign it gets there, or where the sign can no longer
/// be decided.
Real leave_start(const FieldOnRay& field, RootSearch& search, Real end) {
  const FieldOnRay::Active all = field.all();
  for (int halving = 0; halving < 100; ++halving, end /= 2) {
    const int sign = field.over(all, 0, end).derivative.sign();
    if (sign == 0) continue;
    search.constant(sign);
    return end;
  }
  search.doubt(0, end);
  return end;
}

}  // namespace

FirstRoot first_root(FieldOnRay& field, const RootOptions& options) {
  RootSearch search(field, options.enough);
  const FieldOnRay::Active all = field.all();
  const Real begin = std::max(field.begin(), Real(0)), end = std::min(field.end(), options.t_max);
  if (all.empty()) return search.finish();
  if (begin >= end) {  // nothing changes beyond the ray's start
    if (const int sign = field.at(all, 0).value.sign(); !options.starts_on_root && sign != 0) search.constant(sign);
    return search.finish();
  }
  Real from = begin;
  const FieldRange start = field.at(all, 0);
  // A start may be off by the tolerance. In a wall that a carving component makes steeper than that, its level may lie
  // far below the surface's, and mean nothing; but it is outside.
  const bool is_beyond_wall = start.value.hi < -abs(field.threshold());
  if (options.starts_on_root && !is_beyond_wall) {
    // The start is only as near to the surface as doubles allow. Near it, the level on which it lies counts, until the
    // ray is eight times as far away as the start is off. Farther away, where F can be steep, the surface itself
    // counts.
    const Real offset = start.value.middle();
    field.raise_threshold(offset);
    from = leave_start(field, search, end);
    const Real settled = std::min(end, std::max(from, 8 * abs(offset) / start.derivative.mignitude()));
    search.isolate(all, from, field.at(all, from).value.sign(), settled, field.at(all, settled).value.sign());
    from = settled;
    field.raise_threshold(-offset);
  } else {
    const int sign = start.value.sign() != 0 ? start.value.sign() : options.coming_from;
    if (sign != 0) search.constant(sign);
  }
  search.isolate(all, from, field.at(all, from).value.sign(), end, field.at(all, end).value.sign());
  return search.finish();
}

Real crossing_in(const FieldOnRay& field, const Bracket& bracket, Real guess, int sign0, Real enough) {
  RootSearch search(field, enough);
  search.refine(field.all(), bracket, guess, sign0);
  return *search.finish().crossing;
}

}  // namespace isl::ISL_EXTENDED
