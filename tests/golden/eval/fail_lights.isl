light_source { 0, rgb 1 radius 10 }
light_source { 0, rgb 1 point_at x }
light_source { 0, rgb 1 area_light x, y, 0, 3 }
light_source { 0, rgb 1 area_light x, y }
light_source { 0, rgb 1 looks_like { sphere { 0, 1 } } looks_like { sphere { 0, 2 } } }
light_source { 0, rgb 1 looks_like { } }
light_source { 0, rgb 1 looks_like { sphere { 0, 1 } sphere { 0, 1 } } }
light_source { 0, rgb 1 pigment { rgb 1 } }
light_source { 0, rgb 1 spotlght }
light_source { 0, rgb 1 fade_distance 1/0 }
light_source { "here", rgb 1 }
light_source { 0, rgb 1 area_light x, y, 2, 2 adaptive -1 }
difference { light_group { light_source { 0, 1 } sphere { 0, 1 } } sphere { 0, 2 } }
