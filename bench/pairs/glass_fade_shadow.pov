// The shadow has the colour of the way through the body.
#include "stage.inc"
Clear(cylinder { 0, 2*y, 1 }, material {
  texture { pigment { rgbt 1 } finish { diffuse 0 } }
  interior { fade_distance 1 fade_power 1 fade_color <0.9, 0.5, 0.2> }
})
