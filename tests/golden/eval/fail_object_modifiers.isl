sphere { 0, 1 clipped_by { } }
sphere { 0, 1 bounded_by { 3 } }
sphere { 0, 1 clipped_by { clipped_by } }
sphere { 0, 1 interior_texture { pigment { rgb 1 } } }
sphere { 0, 1 no_shadow off }
sphere { 0, 1 no_shaddow }
sphere { 0, 1 clipped_by { bounded_by box { 0, 1 } } }
