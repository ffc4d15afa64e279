// Images with items that do not exist.
sphere { 0, 1 pigment { image_map { png "a.png" map_type 3 } } }
sphere { 0, 1 pigment { image_map { png "a.png" interpolate 1 } } }
sphere { 0, 1 pigment { image_map { png "a.png" repeat <0, 1> } } }
sphere { 0, 1 pigment { image_map { png "a.png" repeat } } }
sphere { 0, 1 pigment { image_map { png "a.png" filter 300, 1 } } }
sphere { 0, 1 pigment { image_map { png "none" } } }
sphere { 0, 1 pigment { rgb 1 } normal { bump_map { png "a.png" map_type 3 } } }
