// Colours of the language.
#pragma once

namespace isl::scene {

/// Linear red, green, blue, and POV-Ray's filter and transmit (0 is opaque).
struct Colour {
  double red = 0, green = 0, blue = 0, filter = 0, transmit = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

}  // namespace isl::scene
