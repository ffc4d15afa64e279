// The memory in which the fields of a cell are laid out for the inner loops: one for each thread. It grows to
// the longest list and is reused, so that tracing does not allocate. A row is an octet: eight fields along one
// ray, or a field along each of eight rays (a packet).
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/scene/fields.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isl::render {

/// The members of a form (skeletons/ray_form-inl.h): `along` depends on field and ray, `shape` and `amplitude` on the
/// field. `start` and `size` are those of PlacedLanes (lane_rows-inl.h); pieces have `size` only, points neither.
struct alignas(64) LaneRow {
  static constexpr std::size_t kLanes = 8;
  static constexpr std::size_t kMostAlong = 6, kMostShape = 3;

  double along[kMostAlong][kLanes];
  double start[kLanes], size[kLanes];
  double shape[kMostShape][kLanes];
  double amplitude[kLanes];
};

/// The form of a row: quadratics of points, which hold everywhere; quadratics of pieces, which have borders; the ray
/// form of a skeleton; the form of a convolved curve.
enum class LaneForm : std::uint8_t { points, pieces, shapes, curves };

/// Rows first … last − 1, which share kernel and form.
struct LaneRun {
  const KernelConstants* kernel;
  LaneForm form;
  scene::Skeleton skeleton;
  std::uint32_t first, last;
  double surface_alone;  ///< that of the group
};

struct LaneMemory {
  std::vector<LaneRow> rows;  ///< as many as were ever needed; `runs` tells which are in use
  std::vector<LaneRun> runs;

  void reserve(std::size_t count) {
    if (count > rows.size()) rows.resize(2 * count);
  }
};

}  // namespace isl::render
