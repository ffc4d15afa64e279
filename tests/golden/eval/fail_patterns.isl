sphere { 0, 1 pigment { bozo agate_turb 1 } }
sphere { 0, 1 pigment { facets coords 1 } }
sphere { 0, 1 normal { image_map { png "a.png" } } }
sphere { 0, 1 pigment { tiling 28 } }
sphere { 0, 1 pigment { mandel 10 interior 7, 1 } }
sphere { 0, 1 pigment { magnet 3 mandel 10 } }
sphere { 0, 1 pigment { pavement number_of_sides 5 } }
sphere { 0, 1 pigment { bozo noise_generator 4 } }
sphere { 0, 1 pigment { bozo warp { repeat x + y } } }
sphere { 0, 1 pigment { bozo warp { scale 2 } } }
sphere { 0, 1 pigment { slope { point_at x altitude y } } }
sphere { 0, 1 pigment { rgb 1 checker rgb 1, rgb 0 } }
sphere { 0, 1 pigment { spiral1 } }
sphere { 0, 1 pigment { gradiant x } }
sphere { 0, 1 pigment { density_file "a.df3" } }
sphere { 0, 1 pigment { image_map { webp "a.webp" } } }
sphere { 0, 1 pigment { image_map { png "a.png" map_type 9 } } }
sphere { 0, 1 pigment { <1, 0, 0> } }
