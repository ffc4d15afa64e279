// Operands that do not go together, and words of patterns where they do not belong.
sphere { 0, 1 pigment { pavement number_of_sides 4 number_of_tiles 3 pattern 3 } }
sphere { 0, 1 pigment { pavement number_of_tiles 6 number_of_sides 6 } }
sphere { 0, 1 normal { pavement pattern 2 number_of_tiles 3 } }
sphere { 0, 1 texture { pavement number_of_tiles 4 pattern 4 texture_map { [0 pigment { rgb 1 }] } } }
#declare F = function { pattern { pavement pattern 2 } }
sphere { 0, 1 pigment { wood form 2 } }
sphere { 0, 1 pigment { rgb 1 agate_turb 2 } }
sphere { 0, 1 finish { tiling 3 } }
