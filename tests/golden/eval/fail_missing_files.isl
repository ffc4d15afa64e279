#declare P = pigment { image_map { png "missing.png" } }
#declare P = pigment { image_map { png "A.PNG" } }
#declare P = pigment { image_map { png concat("C:\\pictures\\a", ".png") } }
#declare P = pigment { density_file df3 "back\slash.df3" }
#declare P = pigment { image_pattern { jpeg "../eval/MASK.png" } }
#declare N = normal { bump_map { png "/home/nobody/Bumps.png" } }
#declare T = texture { material_map { png "." texture { pigment { rgb 1 } } } }
#include "textures\calls_Ball.inc"
