#default { pigment { rgb <0, 0.25, 1> } }
sphere { 0, 1 pigment { checker pigment { rgb 1 } } }        // the other is the default pigment
sphere { 0, 1 pigment { hexagon pigment { rgb 1 }, rgb 2 } }
sphere { 0, 1 pigment { hexagon rgb 1, pigment { rgb 2 } } }  // the third is hexagon's own colour
