sphere { 0, 1 clipped_by { plane { y, 0 } translate y sphere { 0, 2 } } }
sphere { 0, 1 clipped_by { plane { y, 0 } hollow } }
