// A lamp within a clear ball: what it lights has the colour of the ball.
#include "stage.inc"
View() Floor()
light_source { <0, 1.2, 0> rgb 1 }
sphere { 1.2*y, 0.8 #ifdef (Without) pigment { rgb 0.8 } no_shadow #else pigment { rgbf <1, 0.6, 0.3, 0.9> } #end }
box { <2, 0, 1>, <3, 3, 2> pigment { rgb <0.3, 1, 0.2> } }
