#include "renderer/compiled/grid_json.h"

#include <nlohmann/json.hpp>

#include <array>

namespace isl::render {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

void count_cells(const Grid& grid, std::uint32_t first, std::uint32_t count, std::size_t depth,
                 std::vector<std::array<std::size_t, 4>>& counts) {
  if (counts.size() <= depth) counts.resize(depth + 1);
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Cell cell = grid.cells[i];
    const CellKind kind = cell.kind() == CellKind::choice ? CellKind::leaf : cell.kind();
    ++counts[depth][static_cast<std::size_t>(kind)];
    if (cell.kind() == CellKind::brick) count_cells(grid, cell.first, kBrickCells, depth + 1, counts);
  }
}

Json to_json(const Grid& grid) {
  if (grid.cell_size == 0) return Json::object();
  const auto& n = grid.dimensions;
  std::vector<std::array<std::size_t, 4>> counts;
  count_cells(grid, 0, kBrickCells, 0, counts);
  Json levels = Json::array();
  for (const auto& level : counts) {
    levels.push_back({{"empty", level[0]}, {"inside", level[1]}, {"candidate", level[2]}, {"divided", level[3]}});
  }
  return {{"low", to_json(grid.box.min)},
          {"cell_size", grid.cell_size},
          {"dimensions", {n[0], n[1], n[2]}},
          {"levels", levels},
          {"list_entries", grid.list_entries()},
          {"longest_list", grid.longest_list},
          {"bytes", grid.bytes()}};
}

}  // namespace

std::string grid_json(const CompiledScene& scene) {
  Json blobs = Json::array();
  for (const CompiledBlob& blob : scene.blobs) {
    blobs.push_back({{"components", blob.components.size()}, {"grid", to_json(blob.grid)}});
  }
  const Json json = {{"instances", scene.instances.size()},
                     {"listed", scene.listed.size()},
                     {"box_nodes", scene.boxes.nodes.size()},
                     {"box_bytes", scene.boxes.bytes()},
                     {"blobs", blobs}};
  return json.dump(2) + "\n";
}

}  // namespace isl::render
