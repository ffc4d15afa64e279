light_source { <1, 2, 3>, rgb 1 spotlight }
light_source { <1, 2, 3>, rgb 1 spotlight radius 10 falloff 20 tightness 5 point_at 0 translate x }
light_source { 0, rgb 1 cylinder point_at y scale 2 }
light_source { 0, rgb 1 parallel point_at <0, -1, 0> rotate 90*z }
light_source { 0, rgb 1 spotlight parallel shadowless }
light_source { 0, rgb 1 area_light 2*x, 3*y, 4, -5.5 adaptive 1 jitter rotate 90*y }
light_source { 0, rgb 1 area_light x, 2*y, 3, 4 circular orient area_illumination on }
light_source { 0, rgb 1 area_light x, y, 3, 3 orient area_illumination }
light_source { 0, rgb 1 orient jitter }
light_source { 0, rgb 1 fade_distance 10 fade_power 2 media_interaction off media_attenuation on }
// The looks_like object stands at the light's location and moves with the light.
light_source { 9*x, rgb 1 looks_like { sphere { 0, 1 pigment { rgb x } } } translate y }
light_source { 9*x, rgb 1 translate y looks_like { sphere { 0, 2 } } translate y }
light_source { 0, rgb 1 projected_through { box { -1, 1 translate z } } translate 5*y }
#declare Lamp = light_source { 0, rgb 1 looks_like { sphere { 0, 3 } } }
union { sphere { 0, 4 } light_source { Lamp translate x } rotate 90*z }
light_source { x, rgb 1 area_light 2*x, y, 3, 5 circular jitter rotate 90*z scale 2 translate 9 }
light_source { x, rgb 1 rotate 90*z area_light 0, 0, 2, 2 }
