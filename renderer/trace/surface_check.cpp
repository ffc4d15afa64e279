#include "renderer/trace/surface_check.h"

#include "renderer/solvers/cells/extended_search.h"

#include <cmath>

namespace isl::render {

bool is_refuted(const CompiledBlob& blob, const FoundPlace& place, const BlobFields& found, RaySteps steps) {
  const double magnitude = std::abs(blob.components.threshold) + found.magnitude;
  // Nearly all hits pass this test: F is as near to the threshold as the step and the rounding of its terms explain.
  // Its 2⁻⁴⁰ is generous, since the rare hit that fails is judged by a proof.
  const double off = std::abs(found.value - blob.components.threshold);
  if (off <= std::abs(found.gradient.dot(place.step)) + 0x1p-40 * magnitude) return false;
  const Grid& grid = blob.grid;
  const Cell& cell = grid.cells[place.cell];
  for (std::uint32_t i = 0; i < grid.list_count(cell); ++i) {
    const ItemList list = grid.list(cell, i);
    const LaidOutFields fields{&blob.components, grid.items.data() + list.first, list.count, place.point - place.step,
                               place.step * 2};
    if (may_cross(fields, 0, 1, steps)) return false;
  }
  return true;
}

}  // namespace isl::render
