#include "renderer/fields/kernels/kernel_levels.h"

namespace isl::render {

KernelLevels::KernelLevels(const KernelConstants& kernel)
    : piece_(kernel.support / kPieces), per_piece_(kPieces / kernel.support) {
  for (std::size_t i = 0; i < kPieces; ++i) values_[i] = kernel_profile(kernel, static_cast<double>(i) * piece_);
  values_[kPieces] = 0;
}

double KernelLevels::most_at(double v) const {
  const double place = v * per_piece_;
  if (!(place < kPieces)) return 0;
  const auto piece = static_cast<std::size_t>(place);
  const double begin = values_[piece];
  return begin + (place - static_cast<double>(piece)) * (values_[piece + 1] - begin);
}

double KernelLevels::farthest_with(double level) const {
  if (values_[0] < level) return -1;
  std::size_t piece = 0;  // the last that begins with at least this level
  for (std::size_t step = kPieces / 2; step > 0; step /= 2) {
    if (values_[piece + step] >= level) piece += step;
  }
  const double begin = values_[piece], end = values_[piece + 1];
  return (static_cast<double>(piece) + (begin - level) / (begin - end)) * piece_;
}

}  // namespace isl::render
