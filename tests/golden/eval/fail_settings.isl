global_settings { assumed_gamma 0 }
global_settings { max_trace_level 0 }
global_settings { noise_generator 4 }
global_settings { mm_per_unit -1 }
global_settings { charset latin }
global_settings { adc_bailout 1, max_trace_level 3 }
global_settings { radiosity { count 10 } photons { count 10 } subsurface { } }
global_settings { max_trace_levl 3 }
