#declare N = normal { dents 0.7 scale 2 }
#declare Slopes = slope_map { [0 <0, 1>] [0.5, <1, 0>] }
sphere { 0, 1 normal { bumps } }
sphere { 0, 1 normal { bumps, 0.3 accuracy 0.001 no_bump_scale } }
sphere { 0, 1 normal { gradient x, -2 slope_map { Slopes } } }
sphere { 0, 1 normal { wood 0.2 slope_map { [0 <0, 1>] [1 <1, -1>] } sine_wave } }
sphere { 0, 1 normal { N } }
sphere { 0, 1 normal { N 0.3 bump_size 4 translate x } }
sphere { 0, 1 normal { checker normal { N } normal { bumps 0.2 } } }
sphere { 0, 1 normal { hexagon 0.4 } }
sphere { 0, 1 normal { average normal_map { [1 N] [2 granite 0.1] } } }
sphere { 0, 1 normal { facets coords 0.1 } }
sphere { 0, 1 normal { facets size 0.2 } }
sphere { 0, 1 normal { bump_map { png "bumps.png" interpolate 2 use_index bump_size 2 } scale 3 } }
sphere { 0, 1 normal { mandel 10, 0.3 exponent 3 } }
sphere { 0, 1 normal { ripples 0.1 frequency 3 normal_map { [0 N] [1 bumps] } } }
sphere { 0, 1 texture { no_bump_scale pigment { rgb 1 } normal { N } } }
sphere { 0, 1 normal { slope y 0.7 normal_map { [0 bumps] [1 dents] } } }
