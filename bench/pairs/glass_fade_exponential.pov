// Light fades by Beer's law.
#include "stage.inc"
Clear(merge { sphere { <-0.4, 1, 0>, 0.9 } sphere { <0.5, 1, 0>, 0.8 } }, material {
  texture { Tint }
  interior { ior 1.5 fade_distance 0.8 fade_power 1001 fade_color <0.8, 0.3, 0.2> }
})
