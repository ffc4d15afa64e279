// The memory in which RayLanes lays out the fields of a cell: one a thread, grown to the longest list and reused, so
// that tracing allocates nothing. Columns of doubles, 64-byte aligned, each `stride` long.
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"

#include <hwy/aligned_allocator.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace isl::render {

/// A table of doubles by column.
class LaneTable {
 public:
  explicit LaneTable(int columns) : columns_(columns) {}

  /// Room for `rows` rows; what was there is lost if the table has to grow.
  void reserve(std::size_t rows) {
    if (rows <= stride_) return;
    stride_ = (rows + 63) / 64 * 64;
    data_ = hwy::AllocateAligned<double>(stride_ * static_cast<std::size_t>(columns_));
  }
  [[nodiscard]] double* row(std::uint32_t i) const { return data_.get() + i; }
  /// Row i, all columns in order.
  void set_row(std::uint32_t i, std::initializer_list<double> columns) const {
    double* at = row(i);
    for (const double x : columns) {
      *at = x;
      at += stride_;
    }
  }
  [[nodiscard]] std::size_t stride() const { return stride_; }

 private:
  int columns_;
  std::size_t stride_ = 0;
  hwy::AlignedFreeUniquePtr<double[]> data_;
};

/// Rows first … last − 1 of a table, whole octets.
struct LaneSpan {
  std::uint32_t first, last;

  [[nodiscard]] bool is_empty() const { return first == last; }
};

/// Lanes of one kernel.
struct LaneRun {
  const KernelConstants* kernel;
  bool has_pieces;  ///< quadratic lanes hold on [begin, end) only
  LaneSpan quadratics, cones, circles;
  LaneSpan segments, rings;  ///< convolved
};

struct LaneMemory {
  enum QuadraticColumn { kV0, kKappa, kMiddle, kAmplitude, kBegin, kEnd, kQuadraticColumns };
  enum ConeColumn { kX0, kDx, kN0, kN2, kNMiddle, kRadius, kSlope, kLength, kConeAmplitude, kConeColumns };
  enum CircleColumn { kZ0, kDz, kC0, kC2, kCMiddle, kRing, kInverse, kCircleAmplitude, kCircleColumns };

  enum SegmentColumn { kBefore, kBehind, kSegmentDx, kS0, kS2, kSMiddle, kWhole, kSegmentAmplitude, kSegmentColumns };
  enum RingColumn { kRingZ0, kRingDz, kR0, kR2, kRMiddle, kRadiusOfRing, kRingAmplitude, kRingColumns };

  LaneTable quadratic{kQuadraticColumns};
  LaneTable cone{kConeColumns};
  LaneTable circle{kCircleColumns};
  LaneTable segment{kSegmentColumns};
  LaneTable ring{kRingColumns};
  std::vector<LaneRun> runs;

  /// Room for a cell of `count` components: a triangle makes up to ten lanes, and every run is filled up to an octet; a
  /// list cannot change group more often than it has entries.
  void reserve_lanes(std::uint32_t count) {
    constexpr std::size_t kMostPieces = 10, kMostFill = 8;
    quadratic.reserve((kMostPieces + kMostFill) * std::size_t{count} + kMostFill);
    cone.reserve((1 + kMostFill) * std::size_t{count} + kMostFill);
    for (LaneTable* const table : {&circle, &segment, &ring})
      table->reserve((1 + kMostFill) * std::size_t{count} + kMostFill);
    runs.reserve(count);
  }
};

}  // namespace isl::render
