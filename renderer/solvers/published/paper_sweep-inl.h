// The sweep along the ray from one end of an interpolant to the next, for the published solver: which fields are
// active, their sum, and where it first crosses the threshold. It goes only as far as it is told, since fields may be
// met on the way.
#if defined(ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_SWEEP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_SWEEP_INL_H_
#undef ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_SWEEP_INL_H_
#else
#define ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_SWEEP_INL_H_
#endif

#include "renderer/solvers/published/paper_fields-inl.h"
#include "renderer/solvers/published/paper_sums.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// The stretch of the ray that is swept; t counts from `base`.
struct PaperStretch {
  double base, reach;  ///< the ray ends at t = reach
  bool starts_on_surface, may_go_in;
};

class PaperSweep {
 public:
  PaperSweep(const CompiledBlob& blob, const PaperSwitches& switches, const PaperStretch& stretch, PaperFields& fields,
             PaperMemory& memory)
      : threshold_(blob.components.threshold),
        switches_(switches),
        stretch_(stretch),
        fields_(fields),
        m_(memory),
        sums_(blob, memory) {}

  /// The first crossing on the stretches that end by t = `until`. Precondition: every field that begins before has been
  /// met.
  [[nodiscard]] std::optional<double> advance(double until) {
    put_in_order();
    while (at_ < stretch_.reach) {
      update_active();
      const double to = next_end();
      if (!(to <= until) || to == kFar) return std::nullopt;
      const std::optional<double> t = crossing_between(at_, to);
      if (t) return t;
      at_ = to;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_inside() const { return side_ < 0; }

  /// True if an active field is part of the sum that crossed.
  [[nodiscard]] bool crosses(std::size_t active) const { return sums_.has(crossing_sum_, active); }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  [[nodiscard]] double begin_of(std::uint32_t field) const { return m_.nodes[m_.fields[field].first_node].t; }

  /// Sorts the fields met since the last call by where they begin, so that sums do not depend on how they were met.
  void put_in_order() {
    if (ordered_ == m_.waiting.size()) return;
    std::sort(m_.waiting.begin() + static_cast<std::ptrdiff_t>(next_), m_.waiting.end(), [&](auto a, auto b) {
      return std::pair(begin_of(a), m_.fields[a].item) < std::pair(begin_of(b), m_.fields[b].item);
    });
    ordered_ = m_.waiting.size();
    if (!switches_.on_demand) interpolate_ahead();
  }

  /// Interpolates all fields that have been met. With rejection, it leaves out the fields of which every stretch will
  /// be skipped; this can be decided here, because the sum of peaks rises only where a field begins.
  void interpolate_ahead() {
    m_.overlapping = m_.active;
    for (std::size_t i = next_; i < m_.waiting.size(); ++i) {
      const double begin = begin_of(m_.waiting[i]);
      std::erase_if(m_.overlapping,
                    [&](std::uint32_t index) { return m_.nodes[m_.fields[index].last_node].t <= begin; });
      m_.overlapping.push_back(m_.waiting[i]);
      if (switches_.reject && sum_of_peaks(m_.overlapping) < threshold_) continue;
      for (const std::uint32_t index : m_.overlapping) fields_.interpolate(m_.fields[index]);
    }
  }

  void update_active() {
    while (next_ < m_.waiting.size() && begin_of(m_.waiting[next_]) <= at_) m_.active.push_back(m_.waiting[next_++]);
    std::erase_if(m_.active, [&](std::uint32_t index) {
      PaperMemory::Field& field = m_.fields[index];
      while (field.piece < field.last_node && m_.nodes[field.piece + 1].t <= at_) ++field.piece;
      return field.piece == field.last_node;
    });
  }

  [[nodiscard]] double next_end() const {
    double end = next_ < m_.waiting.size() ? begin_of(m_.waiting[next_]) : kFar;
    for (const std::uint32_t index : m_.active) end = std::min(end, m_.nodes[m_.fields[index].piece + 1].t);
    return end;
  }

  /// An upper bound of the sum of these fields, as far as no interpolant exceeds its field.
  [[nodiscard]] double sum_of_peaks(const std::vector<std::uint32_t>& fields) const {
    double sum = 0;
    for (const std::uint32_t index : fields) sum += m_.fields[index].peak;
    return sum;
  }

  [[nodiscard]] std::optional<double> crossing_between(double from, double to) {
    if (switches_.reject && side_ >= 0 && sum_of_peaks(m_.active) < threshold_) {
      side_ = 1;
      return std::nullopt;
    }
    for (const std::uint32_t index : m_.active) fields_.interpolate(m_.fields[index]);
    sums_.add_up(from, to);
    const HermiteSum& greatest = *std::max_element(
        m_.sums.begin(), m_.sums.end(), [](const HermiteSum& a, const HermiteSum& b) { return a.value0 < b.value0; });
    const bool is_start = stretch_.starts_on_surface && side_ == 0;
    if (side_ == 0) {
      // A ray that leaves the surface is outside, whatever the interpolants say of its start, unless it may go in.
      const bool goes_in =
          is_start ? stretch_.may_go_in && greatest.slope0 > 0 : greatest.value0 > 0 && stretch_.base == 0;
      side_ = goes_in ? -1 : 1;
    }
    const double h = to - from;
    PaperSums::Crossing crossing;
    if (is_start && stretch_.may_go_in) {
      crossing = sums_.comes_back_at(h, side_);
    } else if (stretch_.starts_on_surface && side_ * greatest.value0 >= 0) {
      return std::nullopt;
    } else {
      crossing = side_ > 0 ? sums_.enters_at(h, switches_.monotone) : sums_.leaves_at(h, switches_.monotone);
    }
    const double t = from + crossing.u * h;
    if (crossing.u > 1 || t > stretch_.reach || t <= 0) return std::nullopt;
    crossing_sum_ = crossing.sum;
    return t;
  }

  double threshold_;
  PaperSwitches switches_;
  PaperStretch stretch_;
  PaperFields& fields_;
  PaperMemory& m_;
  PaperSums sums_;
  double at_ = 0;
  double side_ = 0;  ///< +1 outside, −1 inside, 0 not known yet
  std::size_t next_ = 0, ordered_ = 0;
  std::size_t crossing_sum_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
