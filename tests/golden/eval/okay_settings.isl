#version 3.7;
global_settings { assumed_gamma srgb ambient_light rgb .5 max_trace_level 9 adc_bailout .01 tolerance "0.1px" max_intersections 64 }
background { color rgb <.1, .2, .3> }
