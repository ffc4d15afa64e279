// Gradient and material weights of a blob at a point, from the list of the cell that holds it.
#if defined(ISL_RENDERER_COMPILED_BLOB_POINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_COMPILED_BLOB_POINT_INL_H_
#undef ISL_RENDERER_COMPILED_BLOB_POINT_INL_H_
#else
#define ISL_RENDERER_COMPILED_BLOB_POINT_INL_H_
#endif

#include "renderer/compiled/compiled_scene.h"
#include "renderer/fields/point/octet_sums-inl.h"
#include "renderer/fields/point/point_sums-inl.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

[[nodiscard]] inline std::span<const std::uint32_t> items_of(const CompiledBlob& blob, const ItemList& list) {
  return {blob.grid.items.data() + list.first, list.count};
}

/// The components of the list whose sum is greatest at the point, for a cell with several lists (CellKind::choice).
[[nodiscard]] inline std::span<const std::uint32_t> greatest_items(const CompiledBlob& blob, std::uint32_t cell_index,
                                                                   const Vec3& point, const ShareRule& rule,
                                                                   BlobPoint& result) {
  ShareSums shares(rule, result.shares);
  const Cell cell = blob.grid.cells[cell_index];
  const std::uint32_t count = blob.grid.list_count(cell);
  std::uint32_t greatest = 0;
  double greatest_value = -std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; count > 1 && i < count; ++i) {
    const std::span<const std::uint32_t> items = items_of(blob, blob.grid.list(cell, i));
    result.evaluations += items.size();
    const double value = sum(point_sums(blob.components, items, point, shares).value);
    if (value > greatest_value) greatest = i, greatest_value = value;
  }
  if (count == 0) return {};
  return items_of(blob, blob.grid.list(cell, greatest));
}

inline void set_blob_point(const CompiledBlob& blob, std::span<const std::uint32_t> items, const Vec3& point,
                           const ShareRule& rule, BlobPoint& result) {
  ShareSums shares(rule, result.shares);
  const PointSums sums = point_sums(blob.components, items, point, shares);
  result.fields.value = sum(sums.value);
  result.fields.magnitude = sum(sums.magnitude);
  result.fields.gradient = {sum(sums.gx), sum(sums.gy), sum(sums.gz)};
  result.evaluations += items.size();
}

inline void blob_point(const CompiledBlob& blob, std::uint32_t cell_index, const Vec3& point, const ShareRule& rule,
                       BlobPoint& result) {
  result.evaluations = 0;
  set_blob_point(blob, greatest_items(blob, cell_index, point, rule, result), point, rule, result);
}

/// The fields of a blob that is one sum (CompiledBlob::is_one_sum) at one to eight points. Returns the number of fields
/// that were evaluated.
inline std::uint64_t blob_fields(const CompiledBlob& blob, std::span<const FieldQuery> queries,
                                 std::span<BlobFields> results) {
  OctetSums sums(queries);
  std::uint64_t evaluations = 0;
  for (std::uint32_t left = (1U << queries.size()) - 1; left != 0;) {
    const std::uint32_t cell = queries[static_cast<std::size_t>(std::countr_zero(left))].cell;
    std::uint32_t lanes = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) lanes |= queries[i].cell == cell ? 1U << i : 0;
    left &= ~lanes;
    const Cell& here = blob.grid.cells[cell];
    if (here.kind() != CellKind::leaf) continue;
    sums.add(blob.components, items_of(blob, blob.grid.list(here, 0)), lanes);
    evaluations += here.count() * static_cast<std::uint64_t>(std::popcount(lanes));
  }
  sums.store_to(results);
  return evaluations;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
