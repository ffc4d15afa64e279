// The working memory of the published solver, one for each thread: the fields that a ray meets with their interpolants,
// and the part of them that shading reuses.
#pragma once

#include "renderer/numerics/cubic.h"

#include <cstdint>
#include <vector>

namespace isl::render {

struct CompiledBlob;

/// Value and slope at both ends of a stretch.
struct HermiteSum {
  double value0 = 0, slope0 = 0, value1 = 0, slope1 = 0;

  HermiteSum& operator+=(const HermiteSum& other) {
    value0 += other.value0;
    slope0 += other.slope0;
    value1 += other.value1;
    slope1 += other.slope1;
    return *this;
  }
};

struct PaperMemory {
  /// An end of an interpolant.
  struct Node {
    double t, value, slope;
  };
  /// A field on the ray: cubic Hermite interpolants between neighbouring nodes.
  struct Field {
    std::uint32_t item, branch;
    std::uint32_t first_node, last_node;
    std::uint32_t first_unknown, end_unknown;  ///< nodes that wait for their values
    std::uint32_t piece;                       ///< the node at which the interpolant begins that the sweep is in
    double peak;                               ///< an upper bound of the field's value on the ray; 0 for a negative
                                               ///< field
  };
  /// A cell that the ray crosses, and the t at which the ray leaves it.
  struct VisitedCell {
    double t1;
    std::uint32_t index;
  };
  /// A hit: the fields that make the surface there, ascending, and their interpolants' values. They are `count` entries
  /// of the two columns below.
  struct Record {
    const CompiledBlob* blob;
    std::uint32_t first, count;
  };

  std::vector<Node> nodes;
  std::vector<Field> fields;
  std::vector<std::uint32_t> waiting, active;  ///< fields before the sweep, by where they begin; fields it is in
  std::vector<std::uint32_t> overlapping;      ///< fields that overlap the one that is looked at
  std::vector<VisitedCell> cells;
  std::vector<HermiteSum> branch_sums, sums;           ///< on one stretch: by branch; by selection, less the threshold
  std::vector<std::vector<std::uint32_t>> selections;  ///< the branches of each sum, if the blob has maxima

  std::vector<Record> records;
  std::vector<std::uint32_t> record_items;
  std::vector<double> record_values;
  bool keeps_records = false;

  /// Begins a batch whose hits are shaded (`for_shading`) or not. Records are kept until the next batch that is shaded.
  void begin_batch(bool for_shading) {
    keeps_records = for_shading;
    if (!for_shading) return;
    records.clear();
    record_items.clear();
    record_values.clear();
  }

  /// `keep`: reuses the memory that earlier rays allocated.
  void begin_ray(std::uint32_t components, bool keep) {
    if (!keep) {
      nodes = {};
      fields = {};
      waiting = {};
      active = {};
      overlapping = {};
      cells = {};
      branch_sums = {};
      sums = {};
      selections = {};
    }
    nodes.clear();
    fields.clear();
    waiting.clear();
    active.clear();
    cells.clear();
    if (met_.size() < components || ray_ == 0xFFFFFFFFu) {
      met_.assign(components, 0);
      ray_ = 0;
    }
    ++ray_;
  }
  /// True the first time that this ray meets the component.
  [[nodiscard]] bool meet(std::uint32_t component) {
    if (met_[component] == ray_) return false;
    met_[component] = ray_;
    return true;
  }

  [[nodiscard]] HermiteSum piece_on(const Field& field, double from, double to) const {
    const CubicPoint a = point_at(field, from), b = point_at(field, to);
    return {a.value, a.slope, b.value, b.slope};
  }
  /// Value and slope of the interpolant that the sweep is in.
  [[nodiscard]] CubicPoint point_at(const Field& field, double t) const {
    const Node &a = nodes[field.piece], &b = nodes[field.piece + 1];
    const double h = b.t - a.t;
    const CubicPoint p =
        cubic_at(a.value, a.value + h * a.slope / 3, b.value - h * b.slope / 3, b.value, (t - a.t) / h);
    return {p.value, p.slope / h};
  }

 private:
  std::vector<std::uint32_t> met_;
  std::uint32_t ray_ = 0;
};

}  // namespace isl::render
