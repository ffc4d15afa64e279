// The memory in which the fields of a cell are laid out for the inner loops: one a thread, grown to the longest list
// and reused, so that tracing allocates nothing. A row is an octet: eight fields along one ray, or one field along
// eight rays (a packet).
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/scene/fields.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isl::render {

/// What lies side by side in the lanes of an octet.
enum class InLanes : std::uint8_t { fields, rays };

/// As the form of the run's skeleton has them (skeletons/ray_form-inl.h): of a field and a ray, of the field alone.
template <InLanes kWhat>
struct alignas(64) LaneRow {
  static constexpr std::size_t kLanes = 8, kFields = kWhat == InLanes::fields ? kLanes : 1;
  static constexpr std::size_t kMostAlong = 6, kMostShape = 3;

  double along[kMostAlong][kLanes];
  double shape[kMostShape][kFields];
  double amplitude[kFields];
};

/// What a row's columns are: quadratics of points, which hold everywhere, or of pieces, which have borders; the ray
/// form of a skeleton; the form of a convolved one.
enum class LaneForm : std::uint8_t { points, pieces, shapes, curves };

/// Rows first … last − 1, of one kernel and one form.
struct LaneRun {
  const KernelConstants* kernel;
  LaneForm form;
  scene::Skeleton skeleton;
  std::uint32_t first, last;
};

template <InLanes kWhat>
struct FieldMemory {
  std::vector<LaneRow<kWhat>> rows;  ///< as many as were ever needed; the runs say which are in use
  std::vector<LaneRun> runs;

  void reserve(std::size_t count) {
    if (count > rows.size()) rows.resize(2 * count);
  }
};

using LaneMemory = FieldMemory<InLanes::fields>;
using PacketMemory = FieldMemory<InLanes::rays>;

}  // namespace isl::render
