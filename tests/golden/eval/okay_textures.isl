#declare P = pigment { marble }
#declare N = normal { bumps }
#declare F = finish { phong 1 }
#declare T = texture { P F }
#declare Layers = texture { T } texture { pigment { gradient x color_map { [0 rgbt 1] [1 rgb 1] } } finish { F } }
                  texture { pigment { rgbf <1, 0, 0, 0.5> } }
sphere { 0, 1 texture { P N F } }
sphere { 0, 1 texture { T pigment { rgb 1 } } }
sphere { 0, 1 texture { Layers } }
sphere { 0, 1 texture { Layers finish { ambient 1 } scale 2 } }     // the topmost takes the finish, all are moved
sphere { 0, 1 texture { T } texture { Layers } }                    // what shows through nothing is left out
sphere { 0, 1 texture { T } texture { pigment { rgbt 0.5 } } pigment { rgbt 0.25 } }
sphere { 0, 1 texture { checker texture { T } texture { Layers } scale 3 } }
sphere { 0, 1 texture { hexagon texture { T } } }
sphere { 0, 1 texture { gradient x texture_map { [0 T] [0.5 pigment { rgb 1 } finish { F }] [1 Layers scale 2] } turbulence 1 } }
sphere { 0, 1 texture { tiles { texture { T } tile2 texture { F } } rotate 90*x } }
sphere { 0, 1 texture { material_map { png "index.png" map_type 2 texture { T } texture { P } texture { F } } scale 5 } }
sphere { 0, 1 texture { uv_mapping P scale 2 } }
sphere { 0, 1 texture { uv_mapping checker texture { T } texture { F } } }
sphere { 0, 1 texture { average texture_map { [1 T] [3 Layers] } } }
#declare Map = texture_map { [0 T] [1 F] }
sphere { 0, 1 texture { image_pattern { png "mask.png" } texture_map { Map } } }
sphere { 0, 1 uv_mapping texture { checker texture { T } texture { F } } }
sphere { 0, 1 translate x uv_mapping pigment { P } }
sphere { 0, 1 texture { average texture_map { [T] [2 F] } } }
sphere { 0, 1 pigment { average pigment_map { [P] [wood] [3 P] } } normal { average normal_map { [N] [bumps 0.2] } } }
