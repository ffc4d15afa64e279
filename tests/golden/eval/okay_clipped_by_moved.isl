sphere { 0, 1 clipped_by { plane { y, 0 } box { -1, 1 scale 2 } rotate 90 * z translate x } translate 3 * z }
sphere { 0, 1 clipped_by { plane { y, 0 } translate y } clipped_by { plane { x, 0 } scale 2 } }
