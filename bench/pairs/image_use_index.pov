// `use_index` in an `image_pattern` changes nothing: brightness counts for palettes, too.
#include "stage.inc"
#declare Picture = pigment { image_pattern { png "palette.png" use_index } color_map { [0.3 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.3, 0.2>] [0.9 rgb <1, 1, 0.7>] } }
Clad(Picture)
