// A picture that a scene names: for image_map, bump_map, image_pattern and material_map. The file's bytes come with it,
// so that nothing is looked for twice; the renderer decodes them if a picture needs them.
#pragma once

#include "base/source_span.h"
#include "renderer/scene/ids.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isl::scene {

/// The word before the file's name; `unnamed` if there is none and the file's extension gives the type.
enum class ImageType : std::uint8_t {
  unnamed,
  bmp,
  exr,
  gif,
  hdr,
  iff,
  jpeg,
  pgm,
  png,
  pot,
  ppm,
  sys,
  tga,
  tiff,
  function
};

/// The part of a pixel that is used. `automatic`: the index if the image has a palette and is a material_map, otherwise
/// the colour.
enum class ImageChannel : std::uint8_t { automatic, index, colour, alpha };

/// Transparency of one colour of the palette.
struct PaletteTransparency {
  int index = 0;
  double amount = 0;
};

struct Image {
  ImageType type = ImageType::unnamed;
  std::string file;                          ///< as written
  std::shared_ptr<const std::string> bytes;  ///< of the file; images of one file share them
  FunctionId function = kNoFunction;         ///< type function: sampled over the unit square, width × height
  int width = 0, height = 0;
  int map_type = 0;     ///< POV-Ray's: 0 planar, 1 spherical, 2 cylindrical, 5 toroidal, 7 angular
  int interpolate = 0;  ///< POV-Ray's: 0 none, 2 bilinear, 3 bicubic, 4 normalised distance
  bool once = false;
  double repeat_x = 1, repeat_y = 1;  ///< factors of the coordinates on the image
  double offset_x = 0, offset_y = 0;  ///< moves the image, in widths and heights
  ImageChannel channel = ImageChannel::automatic;
  std::optional<double> gamma;  ///< of the file; nullopt: as the file states
  bool gamma_srgb = false;      ///< the file uses the sRGB transfer curve
  std::optional<bool> premultiplied;
  std::optional<double> filter_all, transmit_all;
  bool scales_opacity = false;  ///< these are factors of the file's own opacity, as in POV-Ray 3.8; else they are added
  std::vector<PaletteTransparency> filters, transmits;
  bool holds_numbers = false;  ///< heights or values, not colours: they are decoded only if the scene names a gamma
  int choices = 0;             ///< the number of textures of a material_map
  OriginId said_at{};          ///< place of the file's name
};

}  // namespace isl::scene
