// Bright spots out of focus take the shape of the lens.
#include "stage.inc"
camera { Eye() focal_point <0, 0.7, -2> aperture 1.2 blur_samples Blur variance 0
  bokeh { pigment { object { box { <0.1, 0.3, -1>, <0.9, 0.7, 1> } color rgb 0, color rgb 1 } } } }
Floor() Solids()
#declare I = 0;
#while (I < 12) sphere { <-2.5 + 0.45 * I, 2 + 0.3 * sin(I), 3>, 0.06 pigment { rgb 3 } finish { ambient 1 diffuse 0 } } #declare I = I + 1; #end
light_source { <-4, 7, -6> rgb 1 }
