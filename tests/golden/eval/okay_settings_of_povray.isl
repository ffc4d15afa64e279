// Numbers out of their bounds that POV-Ray takes.
global_settings { max_trace_level 0 mm_per_unit -1 }
camera { location -5*z sky 0 look_at 0 }
light_source { 5*y rgb 1 area_light x, z, 3, 3 adaptive -1 }
light_source { 5*y rgb 1 area_light x, z, 3, 3 adaptive 25 }
fog { fog_type 3 distance 10 rgb 1 }
fog { distance -10 rgb 1 }
sphere { 0, 1 pigment { mandel -5 } finish { reflection { 0.5 exponent 0 } } }
sphere { 0, 1 pigment { pavement number_of_sides 4 form 5 interior 3 exterior -1 } finish { reflection 0.5 reflection_exponent -1 } }
