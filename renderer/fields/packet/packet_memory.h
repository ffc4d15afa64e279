// The memory in which PacketLanes lays out the fields of a cell along eight rays: one a thread, grown to the longest list and
// reused, so that tracing allocates nothing.
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/fields/packet/ray_packet.h"

#include <cstdint>
#include <vector>

namespace isl::render {

/// One field along eight rays, or a piece of it: a row of LaneMemory for each of them.
struct alignas(64) PacketRow {
  double along[6][kPacket];  ///< columns that differ from ray to ray
  double shape[3];           ///< those that do not
  double amplitude;
};

/// What a row's columns are: the quadratics of points or of pieces, which have borders; the others as in LaneMemory.
enum class PacketForm : std::uint8_t { points, pieces, cones, circles, segments, rings };

/// Rows of one kernel and one form.
struct PacketRun {
  const KernelConstants* kernel;
  PacketForm form;
  std::uint32_t first, last;
};

struct PacketMemory {
  std::vector<PacketRow> rows;  ///< as many as were ever needed; the runs say which are in use
  std::vector<PacketRun> runs;
};

}  // namespace isl::render
