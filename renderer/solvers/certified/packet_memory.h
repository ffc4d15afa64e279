// Memory that a thread reuses from packet to packet.
#pragma once

#include "renderer/fields/packet/ray_packet.h"
#include "renderer/fields/ray/lane_memory.h"

namespace isl::render {

struct PacketMemory {
  RayPacket rays;
  LaneMemory fields;   ///< of the cell that rays meet
  LaneMemory waiting;  ///< of the cells in which rays wait to be searched
};

}  // namespace isl::render
