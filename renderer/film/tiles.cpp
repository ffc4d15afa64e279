#include "renderer/film/tiles.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace isl::render {
namespace {

int floor_to_tile(int value) { return value / kTileSize * kTileSize; }

/// Every second bit of n, from bit 0 on, packed together: undoes the interleaving of a Morton code.
constexpr int even_bits(unsigned n) {
  int result = 0;
  for (int bit = 0; n != 0; ++bit, n >>= 2) result |= static_cast<int>(n & 1u) << bit;
  return result;
}

/// The pixels of the tile at 0, 0 in the order of their Morton codes.
constexpr auto kMortonOrder = [] {
  std::array<Pixel, std::size_t{kTileSize} * kTileSize> order;
  for (unsigned code = 0; code < order.size(); ++code) order[code] = {even_bits(code), even_bits(code >> 1)};
  return order;
}();

/// A fixed permutation: Fisher–Yates with the generator of POV-Ray's rand(), so that it does not depend on a library.
void shuffle(std::vector<PixelRect>& tiles) {
  std::uint32_t state = 1;
  for (std::size_t i = tiles.size(); i > 1; --i) {
    state = state * 1812433253u + 12345u;
    std::swap(tiles[i - 1], tiles[state % i]);
  }
}

}  // namespace

std::vector<PixelRect> tiles_of(const PixelRect& rect, TileOrder order) {
  std::vector<PixelRect> tiles;
  if (rect.empty()) return tiles;
  for (int y = floor_to_tile(rect.y0); y < rect.y1; y += kTileSize) {
    for (int x = floor_to_tile(rect.x0); x < rect.x1; x += kTileSize) {
      tiles.push_back({std::max(x, rect.x0), std::max(y, rect.y0), std::min(x + kTileSize, rect.x1),
                       std::min(y + kTileSize, rect.y1)});
    }
  }
  if (order == TileOrder::reversed) std::reverse(tiles.begin(), tiles.end());
  if (order == TileOrder::shuffled) shuffle(tiles);
  return tiles;
}

void pixels_of(const PixelRect& tile, std::vector<Pixel>& pixels) {
  if (tile.width() == kTileSize && tile.height() == kTileSize) {
    pixels.resize(kMortonOrder.size());
    for (std::size_t i = 0; i < pixels.size(); ++i)
      pixels[i] = {tile.x0 + kMortonOrder[i].x, tile.y0 + kMortonOrder[i].y};
    return;
  }
  pixels.clear();
  for (const Pixel& offset : kMortonOrder) {
    const Pixel pixel{tile.x0 + offset.x, tile.y0 + offset.y};
    if (pixel.x < tile.x1 && pixel.y < tile.y1) pixels.push_back(pixel);
  }
}

}  // namespace isl::render
