// Settings of light from around that mean nothing.
global_settings { ambient_occlusion { samples 4 } }
global_settings { ambient_occlusion { distance 0 } }
global_settings { sky_light { distance -1 } }
global_settings { sky_light { samples 0 } }
global_settings { bounce_light { samples 2.5 } }
global_settings { bounce_light { distence 3 } }
global_settings { sky_lite { } }
sky_light { distance 2 }
light_source { 3*y rgb 1 area_light x, z, -4, 4 jitter }
