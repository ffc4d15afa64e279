// Lights of the size 0, and numbers that lights cannot have.
light_source { 0, rgb 1 area_light 0, 0, 3, 3 }
light_source { 0, rgb 1 area_light x, 0, 3, 3 }
light_source { 0, rgb 1 area_light x, z, 0, 3 }
light_source { 0, rgb 1 area_light x, z, 1e6, 1e6 }
light_source { 0, rgb 1 area_light x, z, 3, 3 adaptive 100 }
light_source { 0, rgb 1 fade_distance -2 fade_power 2 }
light_source { 0, rgb 1 spotlight radius 30 falloff 20 }
