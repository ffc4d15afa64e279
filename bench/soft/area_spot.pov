// A spotlight with an area, which fades.
#include "stage.inc"
Sharp() Floor() Solids()
light_source { <-3, 6, -4> rgb 1.4 spotlight point_at <0, 0.4, 0> radius 14 falloff 22 fade_distance 8 fade_power 2 area_light <1.5, 0, 0>, <0, 0, 1.5>, 8, 8 jitter }
