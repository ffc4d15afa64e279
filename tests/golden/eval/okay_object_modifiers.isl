sphere { 0, 1 no_shadow no_image no_reflection double_illuminate hollow inverse }
sphere { 0, 2 hollow off inverse inverse no_radiosity }
sphere { 0, 3 pigment { rgb x } interior_texture { pigment { rgb y } } }
// Transforms after clipped_by and bounded_by move the clipping and bounding objects too; earlier ones do not.
sphere { 0, 4 translate x clipped_by { plane { y, 0 } } translate 10*z }
sphere { 0, 5 clipped_by { plane { y, 0 } } clipped_by { plane { x, 0 } box { -9, 9 } } }
sphere { 0, 6 bounded_by { box { -6, 6 } } clipped_by { bounded_by } }
sphere { 0, 7 clipped_by { box { -7, 0 } } bounded_by { clipped_by } scale 2 }
sphere { 0, 8 clipped_by { bounded_by } }
#declare Half = sphere { 0, 9 clipped_by { plane { y, 0 } } }
object { Half clipped_by { plane { x, 0 } } }
object { Half scale 3 }
