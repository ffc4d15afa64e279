// The picture cut into squares that threads take one by one.
#pragma once

#include "renderer/image/image.h"

#include <vector>

namespace isl::render {

/// Side of a tile in pixels. 32² rays make a batch that fills vectors and still fits the second-level cache; 800×600
/// gives 475 tiles, enough to keep any number of threads of one machine busy to the end.
inline constexpr int kTileSize = 32;

/// The order in which tiles are handed out. A picture must not depend on it; the other orders exist to test that.
enum class TileOrder : std::uint8_t { rows, reversed, shuffled };

/// Tiles of `rect`, aligned to multiples of kTileSize of the whole picture.
[[nodiscard]] std::vector<PixelRect> tiles_of(const PixelRect& rect, TileOrder order);

/// A pixel of the picture.
struct Pixel {
  int x = 0, y = 0;
};

/// The pixels of a tile along a Morton curve, so that neighbours in a batch are neighbours in the picture. Replaces
/// `pixels`.
void pixels_of(const PixelRect& tile, std::vector<Pixel>& pixels);

}  // namespace isl::render
