#declare P = pigment_map { [0 rgb 1] }
sphere { 0, 1 pigment { gradient x color_map { } } }
sphere { 0, 1 pigment { gradient x color_map { P } } }
sphere { 0, 1 pigment { gradient x color_map { [0 <1, 0, 0>] } } }
sphere { 0, 1 pigment { gradient x color_map { [0 rgb 1 rgb 0] } } }
sphere { 0, 1 pigment { gradient x color_map { [rgb 1] } } }
sphere { 0, 1 pigment { gradient x color_map { rgb 1 } } }
sphere { 0, 1 pigment { checker color_map { [0 rgb 1] } } }
sphere { 0, 1 pigment { average } }
sphere { 0, 1 pigment { rgb 1 pigment_map { P } } }
sphere { 0, 1 pigment { checker rgb 1, rgb 0, rgb 1 } }
sphere { 0, 1 normal { checker normal_map { [0 bumps] } } }
sphere { 0, 1 texture { gradient x } }
sphere { 0, 1 texture { checker texture_map { [0 pigment { rgb 1 }] } } }
