// The records that every solver of a cell uses: nodes, at which the field along the ray is known, and the lengths below
// which a search may stop.
#if defined(ISL_RENDERER_SOLVERS_CELLS_NODE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_CELLS_NODE_INL_H_
#undef ISL_RENDERER_SOLVERS_CELLS_NODE_INL_H_
#else
#define ISL_RENDERER_SOLVERS_CELLS_NODE_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// A point of the ray with the field there, seen from the side that the ray is on: value < 0 until the ray crosses.
struct Node {
  double t, value, slope;
  double noise, slope_noise;  ///< bounds of how far rounding may have moved them
};

/// Lengths of intervals that are not halved any more, in units of t.
struct Shortest {
  double by_rounding;   ///< a pair of roots closer than this encloses a depth below the rounding of F
  double by_tolerance;  ///< the user's tolerance does not ask to tell shorter ones apart; no less than by_rounding
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
