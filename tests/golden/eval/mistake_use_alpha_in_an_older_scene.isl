#version 3.7;
sphere { 0, 1 finish { use_alpha } }
sphere { 0, 1 finish { use_alpha phong 1 } }
light_source { 0 rgb 1 fade_power 2 }
sphere { 0, 1 finish { fresnel } }
