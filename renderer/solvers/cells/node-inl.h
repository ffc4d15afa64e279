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
  double doubt;               ///< the same for `value`, rounding of positions within components included
};

/// How small a thing a search looks for.
struct Shortest {
  double by_tolerance = 0;        ///< the length of intervals, in units of t, that the user's tolerance does not ask to
                                  ///< tell apart
  bool takes_faint_dips = false;  ///< of BlobRay
  bool digits = false;            ///< of SolverSettings
};

/// Certification may stop at a thousandth of the tolerance.
inline constexpr double kShortestOfTolerance = 1e-3;

/// Halvings of an interval after which the ends of its parts are neighbouring doubles, save next to t = 0, where
/// doubles have no end: there 2⁻¹²⁰ of the whole is less than any digit of the coordinates that a ray is computed from.
inline constexpr int kMostHalvings = 128;
inline constexpr double kLeastShare = 0x1p-120;

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
