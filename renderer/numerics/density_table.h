// A density over the unit square that is constant in the cells of a raster, and its points: a point of the square that
// is chosen evenly becomes one that is chosen by the density. Neighbours stay neighbours but for jumps between rows, so
// evenly spread points stay so.
#pragma once

#include "renderer/numerics/sample_points.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace isl::render {

class DensityTable {
 public:
  struct Place {
    double u = 0, v = 0;  ///< u along rows, v across them
    double density = 1;   ///< its mean over the square is 1
  };

  /// `weights` ≥ 0, row by row; if all are 0 the density is 1 everywhere.
  DensityTable(std::size_t columns, std::size_t rows, std::vector<double> weights)
      : columns_(columns), rows_(rows), weights_(std::move(weights)), row_ends_(rows), ends_(weights_.size()) {
    if (std::ranges::all_of(weights_, [](double weight) { return weight == 0; })) std::ranges::fill(weights_, 1.0);
    double total = 0;
    for (std::size_t row = 0; row < rows_; ++row) {
      double sum = 0;
      for (std::size_t i = row * columns_; i < (row + 1) * columns_; ++i) ends_[i] = sum += weights_[i];
      row_ends_[row] = total += sum;
    }
    for (double& weight : weights_) weight *= static_cast<double>(columns_ * rows_) / total;
  }

  [[nodiscard]] Place place(const UnitPoint& at) const {
    const Found row = find(row_ends_.data(), rows_, at.v);
    const Found column = find(&ends_[row.cell * columns_], columns_, at.u);
    return {(static_cast<double>(column.cell) + column.within) / static_cast<double>(columns_),
            (static_cast<double>(row.cell) + row.within) / static_cast<double>(rows_),
            weights_[row.cell * columns_ + column.cell]};
  }
  /// `u` and `v` in [0, 1].
  [[nodiscard]] double density(double u, double v) const {
    const auto cell = [](double x, std::size_t count) {
      return std::min(static_cast<std::size_t>(x * static_cast<double>(count)), count - 1);
    };
    return weights_[cell(v, rows_) * columns_ + cell(u, columns_)];
  }

 private:
  struct Found {
    std::size_t cell;
    double within;  ///< in [0, 1)
  };
  /// The cell in which a share of the sum ends. Cells of weight 0 are never found.
  [[nodiscard]] static Found find(const double* ends, std::size_t count, double share) {
    const double sought = share * ends[count - 1];
    const double* const end =
        std::min(std::upper_bound(ends, ends + count, sought), std::lower_bound(ends, ends + count, ends[count - 1]));
    const double begin = end == ends ? 0 : *(end - 1);
    return {static_cast<std::size_t>(end - ends), std::clamp((sought - begin) / (*end - begin), 0.0, 1 - 0x1p-53)};
  }

  std::size_t columns_, rows_;
  std::vector<double> weights_;   ///< densities, once they are complete
  std::vector<double> row_ends_;  ///< sums of the rows' weights up to and with each
  std::vector<double> ends_;      ///< the same along each row
};

}  // namespace isl::render
