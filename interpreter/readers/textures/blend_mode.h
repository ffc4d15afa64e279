// `blend_mode` and `blend_gamma` of colour and pigment maps, as POV-Ray 3.8 has them: in which space colours between
// two entries are mixed. The renderer mixes in the scene's working space alone; for another one, a map gets so many
// entries of mixed colours that straight lines between them are as good.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

struct BlendMode {
  int mode = 0;        ///< 0 working space, 1 linear light, 2 encoded with gamma, 3 linear with an encoded brightness
  double gamma = 2.5;  ///< of the modes 2 and 3
};

/// Reads the words, which stand before a map's entries.
[[nodiscard]] BlendMode read_blend_mode(ElementStream& stream);

/// Adds the entries that the mode needs. Pigments with patterns cannot be mixed ahead: they are refused.
void apply_blend_mode(Context& context, const Element& block, const BlendMode& blend, scene::PigmentMap& map);

}  // namespace isl::interpreter
