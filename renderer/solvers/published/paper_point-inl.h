// The data for shading at a hit of the published solver, where they are not the product's own
// (compiled/blob_point-inl.h):
//
//   reuse   the search's interpolants of the fields at the hit weigh the textures, and only those fields are evaluated
//           again, for the gradient;
//   eq10    the normal is Σ fᵢ nᵢ, the fields' own unit normals weighted by their values: the paper's equation 10. It
//           is the gradient's direction only where the fields' slopes are in the ratio of their values, and off by up
//           to tens of degrees at joints. With reuse no kernel is evaluated at all.
//
// A component's own normal is the direction of ∇v, out of its skeleton. For a convolved curve it is the direction of
// the curve's gradient, which costs an evaluation.
#if defined(ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_POINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_POINT_INL_H_
#undef ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_POINT_INL_H_
#else
#define ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_POINT_INL_H_
#endif

#include "base/check.h"
#include "renderer/compiled/blob_point-inl.h"
#include "renderer/solvers/published/paper_memory.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class Equation10 {
 public:
  /// `values` belong to the items, which ascend. If they are empty, they are evaluated.
  Equation10(const CompiledBlob& blob, std::span<const std::uint32_t> items, std::span<const double> values,
             const Vec3& point, const ShareRule& rule, BlobPoint& result)
      : table_(blob.components),
        items_(items),
        values_(values),
        point_(point),
        result_(result),
        shares_(rule, result.shares) {}

  void add_up() {
    shares_.clear();
    for (std::size_t i = 0; i < items_.size();) {
      const FieldGroup& group = table_.group_of(items_[i]);
      std::size_t end = i + 1;
      while (end < items_.size() && end - i < kOctet && items_[end] < group.end) ++end;
      if (group.kernel.is_convolved) {
        for (std::size_t j = i; j < end; ++j) add_curve(group, j);
      } else {
        add_octet(group, i, end);
      }
      i = end;
    }
    result_.fields.gradient = -outward_;
  }

 private:
  void add(std::size_t i, double value, const Vec3& normal) {
    if (value == 0) return;
    outward_ += normal.normalized() * value;
    shares_.add(table_, items_[i], std::abs(value));
  }

  void add_curve(const FieldGroup& group, std::size_t i) {
    const CurveSample f = curve_at(table_, group, items_[i], point_);
    ++result_.evaluations;
    const double value = values_.empty() ? table_.amplitude[items_[i]] * f.value : values_[i];
    add(i, value, -f.gradient);
  }

  void add_octet(const FieldGroup& group, std::size_t begin, std::size_t end) {
    const KernelArguments at = arguments_at(table_, group, items_.subspan(begin, end - begin), point_);
    alignas(64) double value[kOctet], gx[kOctet], gy[kOctet], gz[kOctet];
    store(at.gx, gx);
    store(at.gy, gy);
    store(at.gz, gz);
    if (values_.empty()) {
      with_kernel(group.kernel, [&](const auto& kernel) HWY_ATTR {
        store(keep(at.v < kernel.support(), at.amplitude * kernel.value(at.v)), value);
      });
      result_.evaluations += static_cast<std::uint32_t>(end - begin);
    } else {
      std::copy(values_.begin() + static_cast<std::ptrdiff_t>(begin),
                values_.begin() + static_cast<std::ptrdiff_t>(end), value);
    }
    for (std::size_t i = begin; i < end; ++i) {
      add(i, value[i - begin], {gx[i - begin], gy[i - begin], gz[i - begin]});
    }
  }

  const ComponentTable& table_;
  std::span<const std::uint32_t> items_;
  std::span<const double> values_;
  Vec3 point_;
  BlobPoint& result_;
  ShareSums shares_;
  Vec3 outward_{0};
};

/// `records`: where the search stored what it knows of the hit, and `cell` is the hit's number there. Null if the
/// search stored nothing; then `cell` is a cell of the grid.
inline void paper_point(const CompiledBlob& blob, std::uint32_t cell, const PaperMemory* records, bool eq10,
                        const Vec3& point, const ShareRule& rule, BlobPoint& result) {
  result.evaluations = 0;
  if (records == nullptr) {
    const std::span<const std::uint32_t> items = greatest_items(blob, cell, point, rule, result);
    if (eq10) return Equation10(blob, items, {}, point, rule, result).add_up();
    return set_blob_point(blob, items, point, rule, result);
  }
  ISL_CHECK(cell < records->records.size() && records->records[cell].blob == &blob,
            "hit {} of {} belongs to an earlier batch or to another thread", cell, records->records.size());
  const PaperMemory::Record& record = records->records[cell];
  const std::span<const std::uint32_t> items(records->record_items.data() + record.first, record.count);
  const std::span<const double> values(records->record_values.data() + record.first, record.count);
  if (eq10) return Equation10(blob, items, values, point, rule, result).add_up();
  set_blob_point(blob, items, point, rule, result);
  ShareSums shares(rule, result.shares);
  shares.clear();
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (values[i] != 0) shares.add(blob.components, items[i], std::abs(values[i]));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
