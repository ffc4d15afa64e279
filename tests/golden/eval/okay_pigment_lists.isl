#declare Blue = rgb z;
#declare P = pigment { wood }
sphere { 0, 1 pigment { checker } }
sphere { 0, 1 pigment { checker Blue } }
sphere { 0, 1 pigment { checker Blue, rgb <1, 2, 3>, scale 2 } }
sphere { 0, 1 pigment { checker <1, 0, 0>, 0.5 } }
sphere { 0, 1 pigment { checker color red 1 color green 1 filter 0.5 } }
sphere { 0, 1 pigment { checker pigment { P scale 2 } pigment { rgb 1 } } }
sphere { 0, 1 pigment { brick Blue brick_size 2 } }
sphere { 0, 1 pigment { hexagon Blue, Blue } }
sphere { 0, 1 pigment { square rgb 1 rgb 2 rgb 3 rgb 4 } }
sphere { 0, 1 pigment { triangular } }
sphere { 0, 1 pigment { cubic } }
sphere { 0, 1 pigment { checker } }  // shares what the first had
