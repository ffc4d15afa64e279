// The positions of a pixel's samples: a rank-1 lattice, the same in every pixel, so that nothing depends on the order
// of work.
#pragma once

#include <vector>

namespace isl::render {

/// The offset from the pixel's centre, in pixels; each coordinate is in [−½, ½).
struct SampleOffset {
  double x = 0, y = 0;
};

/// `count` ≥ 1 points. The first is the centre, and each coordinate takes `count` equally spaced values, one for each
/// point.
[[nodiscard]] std::vector<SampleOffset> sample_pattern(int count);

}  // namespace isl::render
