spehre { 0, 2 pigment { rgb 1 } }
