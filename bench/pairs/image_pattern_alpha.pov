// The alpha of a picture is a pattern.
#include "stage.inc"
#declare Picture = pigment { image_pattern { png "alpha.png" use_alpha } color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.3, 0.2>] [1 rgb <1, 1, 0.7>] } }
Clad(Picture)
